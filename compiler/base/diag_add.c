/* Adds diagnostics to a session: each one only once, and at most MAX_DIAGS. */
#include "compiler/base/session.h"
#include "compiler/base/warnings.h"
#include <string.h>

bool diag_full(const Session *session) { return session->diags.count >= MAX_DIAGS; }

const char *diag_suggest(const Session *session, const char *name, SuggestName *names,
                         const void *user, int count)
{
    return diag_full(session) ? "" : suggest(session->arena, name, names, user, count);
}

const char *diag_suggest_or_list(const Session *session, const char *name, const NameChoice *names,
                                 const char *before)
{
    const char *near = diag_suggest(session, name, names->name, names->user, names->count);
    if (*near || diag_full(session) || !before)
        return near;
    Text list = text_new(session->arena);
    text_format(&list, "%s%s", before, suggest_list(session->arena, names));
    return list.at;
}

void *diag_add(Session *session, Span span, DiagKind kind, ...)
{
    const Severity severity = warnings_severity(session_warnings(session), kind);
    if (severity == SEVERITY_none)
        return NULL;
    if (diag_full(session)) {
        session->diags.errors += severity == SEVERITY_error;
        return NULL;
    }
    va_list args;
    session->message.arena = session->arena;
    session->message.size = 0;
    va_start(args, kind);
    diag_message(&session->message, kind, args);
    va_end(args);
    /* Several slots can query one node and find one fault: report each fault only once. */
    for (size_t i = 0; i < session->diags.count; i++) {
        const Diag *reported = &session->diags.at[i];
        if (reported->kind == kind && !memcmp(&reported->span, &span, sizeof span) &&
            !strcmp(reported->message, session->message.at))
            return NULL;
    }
    const char *message = arena_string(session->arena, session->message.at, session->message.size);
    Diag diag = {kind, severity, span, message};
    ARENA_PUSH(session->arena, session->diags.at, session->diags.count, session->diags.capacity,
               diag);
    session->diags.errors += severity == SEVERITY_error;
    return NULL;
}

/* Returns true for a note that belongs to the preceding diagnostic. Advice, which is printed as
 * a note too, is a diagnostic of its own. */
static bool is_of_another(const Diag *diag)
{
    return diag_table[diag->kind].severity == SEVERITY_note;
}

/* Returns the index of the diagnostic that a note belongs to; for any other diagnostic its own
 * index. */
static size_t head_of(const DiagList *diags, size_t i)
{
    while (i > 0 && is_of_another(&diags->at[i]))
        i--;
    return i;
}

static bool comes_before(const Diag *a, const Diag *b)
{
    return a->span.file != b->span.file ? a->span.file < b->span.file
                                        : a->span.start < b->span.start;
}

/* Insertion sort, fast enough for MAX_DIAGS entries: each diagnostic moves to its place
 * together with its notes. */
void diag_sort(DiagList *diags)
{
    Diag moved[MAX_DIAGS];
    for (size_t i = 0, end; i < diags->count; i = end) {
        for (end = i + 1; end < diags->count && is_of_another(&diags->at[end]);)
            end++;
        size_t to = i;
        while (to > 0 && comes_before(&diags->at[i], &diags->at[head_of(diags, to - 1)]))
            to = head_of(diags, to - 1);
        memcpy(moved, &diags->at[i], (end - i) * sizeof *moved);
        memmove(&diags->at[to + end - i], &diags->at[to], (i - to) * sizeof *moved);
        memcpy(&diags->at[to], moved, (end - i) * sizeof *moved);
    }
}

const char *diag_all(Session *session, MatcForm form)
{
    Text out = text_new(session->arena);
    if (!session->diags.count)
        return "";
    if (form != MATC_TEXT)
        text_put(&out, "[");
    for (size_t i = 0; i < session->diags.count; i++) {
        if (form == MATC_TEXT) {
            diag_print(&out, &session->diags.at[i], session->sources);
        } else {
            text_put(&out, i ? ",\n " : "\n ");
            diag_print_json(&out, &session->diags.at[i], session->sources);
        }
    }
    if (form != MATC_TEXT)
        text_put(&out, "\n]\n");
    return out.at;
}
