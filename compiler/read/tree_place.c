/* Bytes of a scalar's text -> bytes of its source. Both are walked side by side: of white space a
 * whole run stands for a whole run, since YAML folds lines and takes indentation away; what is
 * behind a backslash is what it was read as; all else is itself.
 *
 *     is: "a +            text  a + b\tc     source  "a +\n  b\tc"
 *       b\tc"             byte 4 of the text, the b, is byte 7 of the source: one run of white
 *                         space became one space */
#include "compiler/read/tree.h"
#include <string.h>

typedef struct {
    const char *at, *end; /* of the source */
    char quote;           /* '"', '\'', or 0 */
    const char *text, *text_end;
} Walk;

static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/* Counts the bytes of a backslash and what belongs to it; *made is how many the text has for
 * them. */
static int escape_size(const Walk *w, int *made)
{
    const char *at = w->at + 1;
    int digits = *at == 'x' ? 2 : *at == 'u' ? 4 : *at == 'U' ? 8 : 0;
    unsigned long code = 0;
    *made = *at == 'N' || *at == '_' ? 2 : *at == 'L' || *at == 'P' ? 3 : 1;
    if (!digits || w->end - at <= digits)
        return 2;
    for (int i = 1; i <= digits; i++)
        code = code * 16 + (unsigned)(text_hex_digit(at[i]) & 15);
    const bool pair = code >= 0xD800 && code < 0xDC00; /* of JSON: two escapes are one character */
    *made = pair ? 4 : code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
    return pair ? 12 : digits + 2;
}

/* A backslash at the end of a line takes the line's end and what indents the next one away. */
static bool is_joined_line(const Walk *w)
{
    return w->quote == '"' && w->at + 1 < w->end && *w->at == '\\' &&
           (w->at[1] == '\n' || w->at[1] == '\r');
}

static void skip_source_space(Walk *w)
{
    while (w->at < w->end && (is_space(*w->at) || is_joined_line(w)))
        w->at += is_joined_line(w) ? 2 : 1;
}

/* White space within a line is itself; where lines end, a run of it stands for a run. */
static void skip_space(Walk *w)
{
    const char *from = w->at;
    skip_source_space(w);
    if (!memchr(from, '\n', (size_t)(w->at - from))) {
        w->text += w->at - from;
        return;
    }
    while (w->text < w->text_end && is_space(*w->text))
        w->text++;
}

/* One character of both, or a run of white space. */
static void advance(Walk *w)
{
    int size = 1, made = 1;
    if (is_space(*w->at) || is_joined_line(w)) {
        skip_space(w);
        return;
    }
    if (w->quote == '"' && *w->at == '\\')
        size = escape_size(w, &made);
    else if (w->quote == '\'' && *w->at == '\'')
        size = 2;
    w->at += size;
    w->text += made;
}

/* Behind an anchor, a tag and the head of a block of lines. */
static void enter(Walk *w)
{
    while (w->at < w->end && (*w->at == '&' || *w->at == '!')) {
        while (w->at < w->end && !is_space(*w->at))
            w->at++;
        skip_source_space(w);
    }
    if (w->at < w->end && (*w->at == '"' || *w->at == '\''))
        w->quote = *w->at++;
    else if (w->at < w->end && (*w->at == '|' || *w->at == '>'))
        while (w->at < w->end && w->at[-1] != '\n')
            w->at++;
    if (!w->quote && w->text < w->text_end && !is_space(*w->text))
        skip_source_space(w);
}

static uint32_t place_of(Walk *w, const char *source, const char *wanted)
{
    while (w->at < w->end && w->text < wanted)
        advance(w);
    return (uint32_t)(w->at - source);
}

Span tree_place(const Session *session, const Tree *scalar, uint32_t start, uint32_t end)
{
    const Source *source = &session->sources[scalar->span.file];
    Walk walk = {.at = source->text + scalar->span.start,
                 .end = source->text + scalar->span.end,
                 .text = scalar->text,
                 .text_end = scalar->text + scalar->count};
    enter(&walk);
    Span span = {.file = scalar->span.file};
    span.start = place_of(&walk, source->text, scalar->text + start);
    span.end = place_of(&walk, source->text, scalar->text + end);
    if (span.end <= span.start)
        span.end = span.start + 1;
    return span;
}
