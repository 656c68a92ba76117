/* Formats diagnostics as text (position, message, source line, caret) or as JSON. */
#include "compiler/base/session.h"
#include "compiler/base/json_write.h"
#include <limits.h>
#include <stdio.h>
#include <string.h>

enum { LONGEST_LINE = 160 };

const DiagRow diag_table[DIAG_COUNT] = {
#define DIAG(name, severity, format, doc) {#name, SEVERITY_##severity, format, doc},
#include "grammar/diags.def"
};

static const char *const severity_name[] = {"note", "warning", "error"};

bool diag_is_named(DiagKind kind)
{
    return diag_table[kind].severity == SEVERITY_warning ||
           diag_table[kind].severity == SEVERITY_advice;
}

/* Formats a message. Each %s of the format is limited to LIMIT_QUOTE bytes, because names in a
 * document have any length: "no map is called '%s'%s" becomes "no map is called '%.256s'%.256s".
 * Only the log of glslang (DIAG_not_valid) is not shortened. */
void diag_message(Text *out, DiagKind kind, va_list args)
{
    enum { FORMAT_CAPACITY = 512 };
    char format[FORMAT_CAPACITY] = "";
    const int most = kind == DIAG_not_valid ? INT_MAX : LIMIT_QUOTE;
    const char *at = diag_table[kind].format;
    size_t size = 0;
    for (const char *part; (part = strstr(at, "%s")); at = part + 2)
        size += (size_t)snprintf(format + size, FORMAT_CAPACITY - size, "%.*s%%.%ds",
                                 (int)(part - at), at, most);
    snprintf(format + size, FORMAT_CAPACITY - size, "%s", at);
    text_format_list(out, format, args);
}

SourcePosition source_position(const Source *source, uint32_t offset)
{
    if (offset > source->size)
        offset = (uint32_t)source->size;
    SourcePosition position = {1, 1, source->text, 0};
    const char *at = source->text + offset;
    for (const char *c = source->text; (c = memchr(c, '\n', (size_t)(at - c))); c++) {
        position.line++;
        position.line_start = c + 1;
    }
    position.column = (int)(at - position.line_start) + 1;
    size_t rest = source->size - (size_t)(position.line_start - source->text);
    const char *end = memchr(position.line_start, '\n', rest);
    position.line_length = (int)(end ? end - position.line_start : (ptrdiff_t)rest);
    if (position.line_length > 0 && position.line_start[position.line_length - 1] == '\r')
        position.line_length--;
    return position;
}

static bool continues_character(char c) { return ((unsigned char)c & 0xC0) == 0x80; }

/* Appends `mark` once for each column that the text occupies when printed; tabs stay tabs where
 * `mark` is a space. */
static void put_columns(Text *out, const char *text, size_t size, char mark)
{
    Text shown = text_new(out->arena);
    text_visible(&shown, text, size);
    for (size_t i = 0; i < shown.size; i++)
        if (!continues_character(shown.at[i]))
            text_char(out, mark == ' ' && shown.at[i] == '\t' ? '\t' : mark);
}

/* Appends the line below the source line: a caret at the span's start, tildes up to its end. */
static void put_caret(Text *out, const SourcePosition *position, uint32_t length)
{
    const size_t line = (size_t)position->line_length, column = (size_t)position->column - 1,
                 from = column < line ? column : line;
    size_t to = length < line - from ? from + length : line;
    while (to > from && to < line && continues_character(position->line_start[to]))
        to++;
    text_put(out, "      | ");
    put_columns(out, position->line_start, from, ' ');
    Text marks = text_new(out->arena);
    put_columns(&marks, position->line_start + from, to - from, '~');
    text_char(out, '^');
    if (marks.size)
        text_add(out, marks.at + 1, marks.size - 1);
    text_char(out, '\n');
}

/* Appends the message in one line, except glslang's log, which has several. A warning's name
 * follows in brackets: " [-Wname]". */
static void put_message(Text *out, const Diag *diag)
{
    const char *at = diag->message;
    for (size_t size; diag->kind == DIAG_not_valid && at[size = strcspn(at, "\n")];
         at += size + 1) {
        text_visible(out, at, size);
        text_char(out, '\n');
    }
    text_visible(out, at, strlen(at));
    if (diag_is_named(diag->kind))
        text_format(out, " [-W%s%s]", diag->severity == SEVERITY_error ? "error=" : "",
                    diag_table[diag->kind].name);
    text_char(out, '\n');
}

void diag_print(Text *out, const Diag *diag, const Source *sources)
{
    if (diag->span.file == NO_FILE) {
        text_format(out, "matc: %s: ", severity_name[diag->severity]);
        put_message(out, diag);
        return;
    }
    const Source *source = &sources[diag->span.file];
    SourcePosition position = source_position(source, diag->span.start);
    text_visible(out, source->name, strlen(source->name));
    text_format(out, ":%d:%d: %s: ", position.line, position.column, severity_name[diag->severity]);
    put_message(out, diag);
    if (!source->size || position.line_length > LONGEST_LINE)
        return;
    text_format(out, "%5d | ", position.line);
    text_visible(out, position.line_start, (size_t)position.line_length);
    text_char(out, '\n');
    put_caret(out, &position, diag->span.end - diag->span.start);
}

void diag_print_json(Text *out, const Diag *diag, const Source *sources)
{
    text_put(out, "{");
    json_member(out, "severity", severity_name[diag->severity]);
    json_next(out, "kind", diag_table[diag->kind].name);
    json_next(out, "message", diag->message);
    if (diag->span.file != NO_FILE) {
        const Source *source = &sources[diag->span.file];
        SourcePosition start = source_position(source, diag->span.start),
                       end = source_position(source, diag->span.end);
        json_next(out, "file", source->name);
        text_format(out, ", \"line\": %d, \"column\": %d, \"endLine\": %d, \"endColumn\": %d",
                    start.line, start.column, end.line, end.column);
    }
    text_put(out, "}");
}

static void complain_in_json(Text *out, Severity severity, const char *what, const char *why)
{
    text_put(out, "[\n {");
    json_member(out, "severity", severity_name[severity]);
    json_next(out, "kind", "run");
    json_next(out, "message", why);
    if (what)
        json_next(out, "subject", what);
    text_put(out, "}\n]\n");
}

void diag_complain(Text *out, MatcForm form, Severity severity, const char *what, const char *why)
{
    if (form == MATC_JSON) {
        complain_in_json(out, severity, what, why);
        return;
    }
    text_format(out, "matc: %s: ", severity_name[severity]);
    if (what) {
        text_visible(out, what, strlen(what));
        text_put(out, ": ");
    }
    text_visible(out, why, strlen(why));
    text_char(out, '\n');
}
