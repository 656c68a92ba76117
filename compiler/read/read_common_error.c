/* Explains a YAML syntax error by its line and the line above it.
 *
 *     map: Checker          libyaml reads "Checker color1" as a scalar of two lines, and
 *       color1: red         reports the ':' after it. The actual error is the deeper
 *                           indentation of color1. */
#include "compiler/read/read_common_error.h"
#include <string.h>

typedef struct {
    /* start of the line, its first word, and its end without the line break */
    const char *start, *word, *end;
    uint32_t indent;
} Line;

static Line line_at(const Source *source, uint32_t offset)
{
    const SourcePosition position = source_position(source, offset);
    const char *start = position.line_start, *end = start + position.line_length;
    size_t indent = strspn(start, " \t");
    if (indent > (size_t)(end - start))
        indent = (size_t)(end - start);
    return (Line){start, start + indent, end, (uint32_t)indent};
}

/* Returns the nearest line above that is neither empty nor a comment; the same line if there is
 * none. */
static Line line_above(const Source *source, const Line *line)
{
    Line above = *line;
    while (above.start > source->text) {
        above = line_at(source, (uint32_t)(above.start - 1 - source->text));
        if (above.word < above.end && *above.word != '#')
            return above;
    }
    return *line;
}

/* Returns the ':' of the line's first key, before a space or the line's end; NULL if it is
 * missing. */
static const char *colon_of(const char *from, const char *end)
{
    for (const char *at = from; at < end && *at != '#'; at++)
        if (*at == ':' && (at + 1 == end || at[1] == ' '))
            return at;
    return NULL;
}

static Span span_to(const Source *source, const YamlFault *fault, const char *from, const char *to)
{
    return (Span){(uint32_t)(from - source->text), (uint32_t)(to - source->text), fault->file};
}

static const char *word_end(const char *word, const char *end)
{
    while (word < end && !strchr(" :,", *word))
        word++;
    return word;
}

/* Reports a missing colon or space: "specular 0.3", "specular:0.3". */
static bool report_no_colon(Session *session, const Source *source, const YamlFault *fault,
                            const Line *line)
{
    const char *end = word_end(line->word, line->end);
    const char *name = arena_string(session->arena, line->word, (size_t)(end - line->word));
    if (end == line->word || !strncmp(line->word, "- ", 2))
        return false;
    if (end < line->end && *end == ':')
        diag_add(session, span_to(source, fault, end, end + 1), DIAG_no_space, name);
    else
        diag_add(session, span_to(source, fault, line->word, end), DIAG_no_colon, name);
    return true;
}

static bool report_indent(Session *session, const Source *source, const YamlFault *fault,
                          const Line *line)
{
    const char *end = word_end(line->word, line->end);
    diag_add(session, span_to(source, fault, line->word, end), DIAG_too_far_in,
             arena_string(session->arena, line->word, (size_t)(end - line->word)));
    return true;
}

static bool report_tab(Session *session, const Source *source, const YamlFault *fault,
                       const Line *line)
{
    const char *tab = memchr(line->start, '\t', line->indent);
    if (tab)
        diag_add(session, span_to(source, fault, tab, line->word), DIAG_tab_indent);
    return tab != NULL;
}

/* Explains "mapping values are not allowed": a ':' inside a value. */
static bool report_second_colon(Session *session, const Source *source, const YamlFault *fault,
                                const Line *line)
{
    const Line above = line_above(source, line);
    const char *colon = colon_of(above.word, above.end), *first = colon_of(line->word, line->end);
    if (first && first < source->text + fault->at) {
        diag_add(session,
                 span_to(source, fault, source->text + fault->at, source->text + fault->at + 1),
                 DIAG_second_colon);
        return true;
    }
    if (above.start == line->start)
        return false;
    if (!colon)
        return report_no_colon(session, source, fault, &above);
    return line->indent > above.indent && report_indent(session, source, fault, line);
}

/* Explains `{ map: Checker color1: red }`: a missing comma in braces or brackets. */
static bool report_no_comma(Session *session, const Source *source, const YamlFault *fault,
                            const Line *line)
{
    const char *end = source->text + fault->at, *word;
    if (*end != ':') {
        word = end;
        end = word + strcspn(word, " ,:]}\r\n");
    } else {
        for (word = end; word > line->start && !strchr(" ,[{", word[-1]);)
            word--;
    }
    if (word < end)
        diag_add(session, span_to(source, fault, word, end), DIAG_no_comma,
                 arena_string(session->arena, word, (size_t)(end - word)));
    return word < end;
}

/* Explains a brace, bracket or quote that is not closed. libyaml reports a later position;
 * `context` is where the collection or string begins.
 *
 *     diffuse: { map: Checker, color1: red      libyaml reads on and reports the ':' of the
 *     specular: 0.5                             next line. That line is not indented deeper
 *                                               than the brace's line, so the brace should
 *                                               have been closed before it. */
static bool report_open(Session *session, const Source *source, const YamlFault *fault,
                        const Line *line)
{
    const char *open = source->text + fault->context, *at = source->text + fault->at;
    const bool quote = *open == '"' || *open == '\'', ends = at == source->text + source->size;
    const Line opening = line_at(source, fault->context);
    const bool later = line->start != opening.start && line->indent <= opening.indent;
    if (!quote && !ends && !later && !strchr("]}", *at))
        return report_no_comma(session, source, fault, line);
    diag_add(session, span_to(source, fault, open, open + 1), DIAG_not_closed, *open);
    if (!ends)
        diag_add(session, span_to(source, fault, later ? line->word : at, at + 1),
                 DIAG_closed_before);
    return true;
}

static bool is_open(const char *problem)
{
    static const char *const problems[] = {
        "did not find expected ',' or '}'", "did not find expected ',' or ']'",
        "found unexpected end of stream", "found unexpected document indicator"};
    bool found = false;
    for (size_t i = 0; i < sizeof problems / sizeof *problems; i++)
        found |= !strcmp(problem, problems[i]);
    return found;
}

/* Returns the '#' of a color that starts a comment in these bytes: after a space, outside
 * quotes. NULL: not found. */
static const char *hash_within(const char *at, const char *end)
{
    char quote = 0;
    for (const char *before = at; at < end; before = at++) {
        if (*at == '#' && !quote && strchr(" \t[{,", *before) &&
            strspn(at + 1, "0123456789abcdefABCDEF") >= 3)
            return at;
        if (*at == '#' && !quote && strchr(" \t\n", *before))
            at += strcspn(at, "\r\n");
        else if (quote ? *at == quote : (*at == '"' || *at == '\'') && strchr(" [{,:(=", *before))
            quote = quote ? 0 : *at;
    }
    return NULL;
}

/* Explains `{ color1: #ff0000, color2: red }`: the '#' starts a comment that includes the
 * closing brace. */
static bool report_hash(Session *session, const Source *source, const YamlFault *fault,
                        const Line *line)
{
    const Line above = line_above(source, line);
    const char *from =
        source->text + fault->context < above.start ? source->text + fault->context : above.start;
    const char *hash = hash_within(from, source->text + fault->at);
    if (!hash)
        return false;
    const char *end = hash + 1 + strspn(hash + 1, "0123456789abcdefABCDEF");
    diag_add(session, span_to(source, fault, hash, end), DIAG_hash_comment,
             arena_string(session->arena, hash, (size_t)(end - hash)));
    return true;
}

bool read_common_error(Session *session, const YamlFault *fault)
{
    const Source *source = &session->sources[fault->file];
    const Line line = line_at(source, fault->at), context = line_at(source, fault->context);
    if (!strcmp(fault->problem, "found unknown escape character") ||
        !strcmp(fault->problem, "did not find expected hexdecimal number")) {
        diag_add(session, (Span){fault->at, fault->at + 1, fault->file}, DIAG_backslash);
        return true;
    }
    const bool lacks =
        is_open(fault->problem) || !strcmp(fault->problem, "did not find expected node content");
    const bool quoted =
        fault->context < source->size && strchr("'\"", source->text[fault->context]);
    if (lacks && !quoted && report_hash(session, source, fault, &line))
        return true;
    if (is_open(fault->problem) && strchr("{['\"", source->text[fault->context]))
        return report_open(session, source, fault, &line);
    if (report_tab(session, source, fault, &line))
        return true;
    if (!strcmp(fault->problem, "could not find expected ':'"))
        return report_no_colon(session, source, fault, &context);
    if (!strcmp(fault->problem, "mapping values are not allowed in this context"))
        return report_second_colon(session, source, fault, &line);
    if (!strcmp(fault->problem, "did not find expected key") && colon_of(line.word, line.end))
        return line.indent > context.indent && report_indent(session, source, fault, &line);
    return false;
}
