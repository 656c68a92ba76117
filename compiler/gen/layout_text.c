#include "compiler/gen/layout_text.h"
#include "compiler/base/text.h"
#include <string.h>

enum { NAME = 64, LINE = 512, ROWS_MAX = 128 };

typedef struct {
    char name[NAME];
    int value;
} Known;

typedef struct {
    const char *file;
    char c_prefix[NAME], glsl_prefix[NAME], type[NAME];
    Known known[ROWS_MAX]; /* names of all rows of the file */
    int known_count, at;   /* `at`: number of words written so far */
    int open;              /* an enum has been opened */
} Layout;

typedef struct {
    char name[NAME], number[LINE], doc[LINE];
    int value, words, is_value;
} Row;

typedef void (*Write)(FILE *out, Layout *layout, const Row *row);

int layout_text_is(const char *path)
{
    static const char suffix[] = ".layout.def";
    const size_t size = strlen(path);
    return size > sizeof suffix - 1 && !strcmp(path + size - (sizeof suffix - 1), suffix);
}

/* Copies text up to one of the characters `ends` and skips that character. Returns 0 if it is
 * missing, or the text does not fit. */
static int take(const char **at, const char *ends, char *to, size_t capacity)
{
    *at += strspn(*at, " ");
    const size_t size = strcspn(*at, ends);
    if (!(*at)[size] || size >= capacity)
        return 0;
    memcpy(to, *at, size);
    to[size] = 0;
    *at += size + 1;
    return 1;
}

static int find_value(const Layout *layout, const char *word, size_t size, int *value)
{
    *value = 0;
    for (size_t i = 0; i < size && text_is_digit(*word); i++) {
        *value = 10 * *value + word[i] - '0';
        if (i + 1 == size)
            return 1;
    }
    for (int i = layout->known_count - 1; i >= 0; i--)
        if (strlen(layout->known[i].name) == size && !memcmp(layout->known[i].name, word, size)) {
            *value = layout->known[i].value;
            return 1;
        }
    return 0;
}

/* Evaluates a sum of products such as "4 * LIGHTS_MAX + 2". Returns 0 for an unknown name. */
static int evaluate(const Layout *layout, const char *text, int *result)
{
    int sum = 0, product = 1, value;
    for (char sign = '*';; text++) {
        text += strspn(text, " ");
        const size_t size = strcspn(text, " *+");
        if (!find_value(layout, text, size, &value))
            return 0;
        sum += sign == '+' ? product : 0;
        product = sign == '+' ? value : product * value;
        text += size;
        text += strspn(text, " ");
        *result = sum + product;
        sign = *text;
        if (sign != '*' && sign != '+')
            return !sign;
    }
}

static int read_head(const char *line, Layout *layout)
{
    static const char tag[] = "LAYOUT(";
    char *const parts[] = {layout->c_prefix, layout->glsl_prefix, layout->type};
    char between[NAME];
    if (strncmp(line, tag, sizeof tag - 1) != 0)
        return 0;
    line += sizeof tag - 1;
    for (int i = 0; i < 3; i++)
        if (!take(&line, "\"", between, NAME) || !take(&line, "\"", parts[i], NAME))
            return 0;
    layout->at = 0;
    return 1;
}

static int read_row(const char *line, Layout *layout, Row *row)
{
    enum { TAG = sizeof "WORDS(" - 1 };
    char between[NAME];
    row->is_value = !strncmp(line, "VALUE(", TAG);
    if ((!row->is_value && strncmp(line, "WORDS(", TAG) != 0) || layout->known_count == ROWS_MAX ||
        !*layout->type)
        return 0;
    line += TAG;
    if (!take(&line, ",", row->name, NAME) || !take(&line, ",", row->number, LINE) ||
        !take(&line, "\"", between, NAME) || !take(&line, "\"", row->doc, LINE) ||
        !evaluate(layout, row->number, &row->words))
        return 0;
    row->value = row->is_value ? row->words : layout->at;
    layout->at += row->is_value ? 0 : row->words;
    Known *known = &layout->known[layout->known_count++];
    strcpy(known->name, row->name);
    known->value = row->value;
    return 1;
}

static int is_upper(char c) { return c >= 'A' && c <= 'Z'; }

static void write_c(FILE *out, Layout *layout, const Row *row)
{
    fputs(layout->open ? "    " : "enum {\n    ", out);
    layout->open = 1;
    fputs(layout->c_prefix, out);
    for (const char *c = row->name; *c; c++)
        fputc(*c >= 'a' && *c <= 'z' ? *c - 'a' + 'A' : *c, out);
    fprintf(out, *row->doc ? " = %d, /* %s */\n" : " = %d,\n", row->value, row->doc);
}

static void write_glsl(FILE *out, Layout *layout, const Row *row)
{
    const int constant = !strncmp(layout->type, "const ", 6),
              is_unsigned = strstr(layout->type, "uint") != NULL;
    if (!constant && (row->is_value || !row->words))
        return;
    fprintf(out, "%s%s %s%s", constant ? "" : "    ", layout->type, layout->glsl_prefix, row->name);
    if (constant)
        fprintf(out, " = %d%s", row->value, is_unsigned ? "u" : "");
    else if (row->words > 1)
        fprintf(out, "[%d]", row->words);
    fprintf(out, *row->doc ? "; // %s\n" : ";\n", row->doc);
}

/* Lines that begin with a capital letter are rows; all others are comments. */
static int write_rows(FILE *out, Layout *layout, const char *text, Write write)
{
    char line[LINE];
    Row row;
    for (int number = 1; *text; number++) {
        const size_t size = strcspn(text, "\n");
        snprintf(line, sizeof line, "%.*s", (int)size, text);
        text += size + (text[size] == '\n');
        if (!is_upper(*line) || read_head(line, layout))
            continue;
        if (!read_row(line, layout, &row)) {
            fprintf(stderr, "embed: %s.def:%d: not a row of a layout: %s\n", layout->file, number,
                    line);
            return 0;
        }
        write(out, layout, &row);
    }
    return 1;
}

int layout_text_c(FILE *out, const char *name, const char *text)
{
    Layout layout = {.file = name};
    fprintf(out, "/* Made by compiler/gen/embed.c from %s.def. */\n#pragma once\n", name);
    const int fine = write_rows(out, &layout, text, write_c);
    if (layout.open)
        fputs("};\n", out);
    return fine;
}

int layout_text_glsl(FILE *out, const char *name, const char *text)
{
    Layout layout = {.file = name};
    return write_rows(out, &layout, text, write_glsl);
}
