/* Diagnostics as text: place, message, source line, caret; or as JSON. */
#include "diag.h"
#include <string.h>

enum { LONGEST_LINE = 160 };

const DiagRow diag_table[DIAG_COUNT] = {
#define DIAG(name, severity, format, doc) {#name, SEVERITY_##severity, format, doc},
#include "grammar/diags.def"
};

static const char *const severity_name[] = {"note", "warning", "error"};

Place source_place(const Source *source, uint32_t offset)
{
    if (offset > source->size)
        offset = (uint32_t)source->size;
    Place place = {1, 1, source->text, 0};
    const char *at = source->text + offset;
    for (const char *c = source->text; (c = memchr(c, '\n', (size_t)(at - c))); c++) {
        place.line++;
        place.line_start = c + 1;
    }
    place.column = (int)(at - place.line_start) + 1;
    size_t rest = source->size - (size_t)(place.line_start - source->text);
    const char *end = memchr(place.line_start, '\n', rest);
    place.line_length = (int)(end ? end - place.line_start : (ptrdiff_t)rest);
    if (place.line_length > 0 && place.line_start[place.line_length - 1] == '\r')
        place.line_length--;
    return place;
}

/* Text of the document as a terminal may have it: control characters and what is not UTF-8 become question marks. */
static void put_clean(Text *out, const char *text, size_t size)
{
    for (size_t i = 0; i < size;) {
        int length = utf8_length((const unsigned char *)text + i, (const unsigned char *)text + size);
        bool control =
            length == 1 && ((unsigned char)text[i] < 0x20 || text[i] == 0x7F) && text[i] != '\t' && text[i] != '\n';
        if (!length || control)
            text_char(out, '?');
        else
            text_add(out, text + i, (size_t)length);
        i += length ? (size_t)length : 1;
    }
}

static bool continues_character(char c) { return ((unsigned char)c & 0xC0) == 0x80; }

/* The line under the source line: a caret at the span's start, tildes to its end, in display columns. */
static void put_caret(Text *out, const Place *place, uint32_t length)
{
    text_put(out, "      | ");
    for (int i = 0; i < place->column - 1 && i < place->line_length; i++)
        if (!continues_character(place->line_start[i]))
            text_char(out, place->line_start[i] == '\t' ? '\t' : ' ');
    text_char(out, '^');
    for (uint32_t i = 1; i < length && place->column - 1 + (int)i < place->line_length; i++)
        if (!continues_character(place->line_start[place->column - 1 + (int)i]))
            text_char(out, '~');
    text_char(out, '\n');
}

void diag_print(Text *out, const Diag *diag, const Source *sources)
{
    if (diag->span.file == NO_FILE) {
        text_format(out, "matc: %s: %s\n", severity_name[diag->severity], diag->message);
        return;
    }
    const Source *source = &sources[diag->span.file];
    Place place = source_place(source, diag->span.start);
    text_format(out, "%s:%d:%d: %s: ", source->name, place.line, place.column, severity_name[diag->severity]);
    put_clean(out, diag->message, strlen(diag->message));
    text_char(out, '\n');
    if (!source->size || place.line_length > LONGEST_LINE)
        return;
    text_format(out, "%5d | ", place.line);
    put_clean(out, place.line_start, (size_t)place.line_length);
    text_char(out, '\n');
    put_caret(out, &place, diag->span.end - diag->span.start);
}

void diag_print_json(Text *out, const Diag *diag, const Source *sources)
{
    text_format(out, "{\"severity\": \"%s\", \"kind\": \"%s\", \"message\": ", severity_name[diag->severity],
                diag_table[diag->kind].name);
    text_json(out, diag->message, strlen(diag->message));
    if (diag->span.file != NO_FILE) {
        const Source *source = &sources[diag->span.file];
        Place start = source_place(source, diag->span.start), end = source_place(source, diag->span.end);
        text_put(out, ", \"file\": ");
        text_json(out, source->name, strlen(source->name));
        text_format(out, ", \"line\": %d, \"column\": %d, \"endLine\": %d, \"endColumn\": %d", start.line, start.column,
                    end.line, end.column);
    }
    text_put(out, "}");
}
