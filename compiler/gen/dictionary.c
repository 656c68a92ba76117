/* Writes the keywords of documents and of the IR's text as a dictionary for libFuzzer and AFL++:
 * dictionary FILE. */
#include "compiler/ir/ir.h"
#include "grammar/scene_tables.h"
#include <stdio.h>

static void word(FILE *out, const char *text)
{
    if (text && *text)
        fprintf(out, "\"%s\"\n", text);
}

static void key(FILE *out, const char *text) { fprintf(out, "\"%s: \"\n", text); }

static void document_words(FILE *out)
{
    static const char *const keys[] = {
        "material", "materials", "map",         "defs",     "ref",    "include", "param",
        "default",  "wave",      "first",       "second",   "factor", "shift",   "value",
        "input",    "blend",     "translation", "rotation", "scale",  "shear",   "matrix",
        "params",   "doc",       "type",        "min",      "max"};
    static const char *const others[] = {
        "<<: *a",  "&a ",  "*a",   "[",     "]",  "{ ",  " }",   ", ",   "- ",
        "\\x0a  ", "null", "true", "false", "-1", "0.5", "1e38", ".inf", "\\\"#ff0000\\\"",
        "Chain"};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        key(out, keys[i]);
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        word(out, others[i]);
    for (int i = 0; i < KIND_COUNT; i++)
        word(out, kind_table[i].name);
    for (int i = 0; i < alias_count; i++)
        word(out, alias_table[i].alias);
    for (int i = 0; i < preset_count; i++)
        word(out, preset_table[i].name);
    for (int i = 0; i < PARAM_COUNT; i++)
        key(out, param_table[i].name);
    for (int i = 0; i < WAVE_COUNT; i++)
        word(out, wave_table[i].name);
}

static void scene_words(FILE *out)
{
    for (int i = 0; i < SCENE_SORT_COUNT; i++)
        key(out, scene_sort_table[i].name);
    for (int i = 0; i < SCENE_KIND_COUNT; i++)
        word(out, scene_kind_table[i].name);
    for (int i = 0; i < SCENE_PARAM_COUNT; i++)
        key(out, scene_param_table[i].param.name);
}

static void ir_words(FILE *out)
{
    static const char *const others[] = {"%1",   " = ", "function f0", "out color 0",
                                         ".xyz", "0.0", "f0"};
    for (int i = 0; i < OP_COUNT; i++)
        word(out, op_table[i].name);
    for (int i = 0; i < TYPE_COUNT; i++)
        word(out, type_table[i].name);
    for (int i = 0; i < INPUT_COUNT; i++)
        word(out, input_table[i].name);
    for (int i = 0; i < FUNCTION_COUNT; i++)
        word(out, function_row(i)->name);
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        word(out, others[i]);
}

int main(int argc, char **argv)
{
    FILE *out = argc == 2 ? fopen(argv[1], "w") : NULL;
    if (!out)
        return 1;
    document_words(out);
    scene_words(out);
    ir_words(out);
    return fclose(out) != 0;
}
