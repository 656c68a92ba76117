/* Maps bytes of a scalar's text to bytes of its source by walking both in parallel. A run of
 * white space corresponds to a run of white space, since YAML folds lines and removes
 * indentation. An escape corresponds to its decoded character, every other byte to itself.
 *
 *     is: "a +            text  a + b\tc     source  "a +
 *   b\tc"
 *       b\tc"             byte 4 of the text, the b, is byte 7 of the source: one run of
 *                         white space became one space */
#include "compiler/read/tree.h"
#include <string.h>

typedef struct {
    const char *at, *end; /* position in the source */
    char quote;           /* kind of quotes: '"', '\'', or 0 for a plain scalar */
    const char *text, *text_end;
} Walk;

static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/* Returns the size of an escape sequence in the source; *made is its size in the text. */
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
    /* JSON surrogate pair: two escapes are one character */
    const bool pair = code >= 0xD800 && code < 0xDC00;
    *made = pair ? 4 : code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
    return pair ? 12 : digits + 2;
}

/* A backslash at the end of a line removes the line break and the next line's indentation. */
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

/* White space within a line corresponds byte by byte; a run across lines corresponds to a run. */
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

/* Advances by one character of both, or by a run of white space. */
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

/* Skips an anchor, a tag and the header of a block scalar. */
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
