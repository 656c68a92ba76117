#include "compiler/gen/layout_text.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { NAME = 64, LINE = 512, ROWS_MAX = 128 };

typedef struct {
    char name[NAME];
    int value;
} Known;

typedef struct {
    const char *file;
    char c_prefix[NAME], glsl_prefix[NAME], type[NAME];
    Known known[ROWS_MAX]; /* of the whole file */
    int known_count, at;   /* words so far */
    int open;              /* an enum was begun */
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

static int find_value(const Layout *layout, const char *word, int *value)
{
    if (isdigit((unsigned char)*word)) {
        *value = atoi(word);
        return 1;
    }
    for (int i = layout->known_count - 1; i >= 0; i--)
        if (!strcmp(layout->known[i].name, word)) {
            *value = layout->known[i].value;
            return 1;
        }
    return 0;
}

/* "4 * LIGHTS_MAX + 2": words and operators in turn. */
static int evaluate(const Layout *layout, const char *text, int *result)
{
    int sum = 0, product = 1, value, used;
    char word[NAME], sign = '*';
    while (sscanf(text, " %63[A-Za-z_0-9]%n", word, &used) == 1 && find_value(layout, word, &value)) {
        sum += sign == '+' ? product : 0;
        product = sign == '+' ? value : product * value;
        text += used;
        if (sscanf(text, " %c%n", &sign, &used) != 1) {
            *result = sum + product;
            return 1;
        }
        text += used;
        if (sign != '*' && sign != '+')
            return 0;
    }
    return 0;
}

static int read_head(const char *line, Layout *layout)
{
    char quoted[3][NAME];
    if (sscanf(line, "LAYOUT(\"%60[^,], \"%60[^,], \"%60[^)])", quoted[0], quoted[1], quoted[2]) != 3)
        return 0;
    char *const parts[] = {layout->c_prefix, layout->glsl_prefix, layout->type};
    for (int i = 0; i < 3; i++) {
        char *end = strchr(quoted[i], '"');
        if (!end || end[1])
            return 0;
        *end = 0;
        strcpy(parts[i], quoted[i]);
    }
    layout->at = 0;
    return 1;
}

static int read_row(const char *line, Layout *layout, Row *row)
{
    row->is_value = !strncmp(line, "VALUE(", 6);
    *row->doc = 0;
    if ((!row->is_value && strncmp(line, "WORDS(", 6) != 0) || layout->known_count == ROWS_MAX || !*layout->type ||
        sscanf(line + 6, "%63[A-Za-z_0-9], %511[^,], \"%511[^\"]", row->name, row->number, row->doc) < 2 ||
        !evaluate(layout, row->number, &row->words))
        return 0;
    row->value = row->is_value ? row->words : layout->at;
    layout->at += row->is_value ? 0 : row->words;
    Known *known = &layout->known[layout->known_count++];
    strcpy(known->name, row->name);
    known->value = row->value;
    return 1;
}

static void write_c(FILE *out, Layout *layout, const Row *row)
{
    fputs(layout->open ? "    " : "enum {\n    ", out);
    layout->open = 1;
    fputs(layout->c_prefix, out);
    for (const char *c = row->name; *c; c++)
        fputc(toupper((unsigned char)*c), out);
    fprintf(out, *row->doc ? " = %d, /* %s */\n" : " = %d,\n", row->value, row->doc);
}

static void write_glsl(FILE *out, Layout *layout, const Row *row)
{
    const int constant = !strncmp(layout->type, "const ", 6), is_unsigned = strstr(layout->type, "uint") != NULL;
    if (!constant && (row->is_value || !row->words))
        return;
    fprintf(out, "%s%s %s%s", constant ? "" : "    ", layout->type, layout->glsl_prefix, row->name);
    if (constant)
        fprintf(out, " = %d%s", row->value, is_unsigned ? "u" : "");
    else if (row->words > 1)
        fprintf(out, "[%d]", row->words);
    fprintf(out, *row->doc ? "; // %s\n" : ";\n", row->doc);
}

/* Lines that begin with a capital are rows; the others are comments. */
static int write_rows(FILE *out, Layout *layout, const char *text, Write write)
{
    char line[LINE];
    Row row;
    for (int number = 1; *text; number++) {
        const size_t size = strcspn(text, "\n");
        snprintf(line, sizeof line, "%.*s", (int)size, text);
        text += size + (text[size] == '\n');
        if (!isupper((unsigned char)*line) || read_head(line, layout))
            continue;
        if (!read_row(line, layout, &row)) {
            fprintf(stderr, "embed: %s.def:%d: not a row of a layout: %s\n", layout->file, number, line);
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
