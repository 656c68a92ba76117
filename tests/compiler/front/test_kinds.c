/* Every parameter of every map and material with values of every kind: a value of an unsuitable
 * kind is an error at the value's place. */
#include "tests/test.h"
#include "compiler/matc.h"
#include "grammar/tables.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A value as it is written behind a key that stands two columns in; what it is of. */
typedef enum {
    SORT_number,
    SORT_map,
    SORT_material,
    SORT_list,
    SORT_none,
    SORT_text,
    SORT_truth,
    SORT_nothing,
    SORT_object,
    SORT_gray,    /* a color of equal components */
    SORT_color,   /* a literal color of unequal components */
    SORT_name,    /* the same by its name, which is none of a formula */
    SORT_defined, /* a definition of such a color */
    SORT_blend,   /* a map of such colors */
} Sort;
static const struct {
    Sort sort;
    const char *text;
} values[] = {{SORT_number, "1"},
              {SORT_map, "{ map: Granite }"},
              {SORT_map, "\n    map: Granite"},
              {SORT_material, "{ material: RGBA }"},
              {SORT_list, "[0.5, 0.25, 0.125]"},
              {SORT_list, "\n    - 0.5\n    - 0.25\n    - 0.125"},
              {SORT_list, "\n  - 0.5\n  - 0.25\n  - 0.125"},
              {SORT_none, "[]"},
              {SORT_text, "nonsense"},
              {SORT_text, "\"nonsense\""},
              {SORT_truth, "true"},
              {SORT_nothing, "null"},
              {SORT_object, "{ sense: 1 }"},
              {SORT_gray, "\"#808080\""},
              {SORT_color, "\"#ff8800\""},
              {SORT_color, "\"#8888ff80\""},
              {SORT_name, "red"},
              {SORT_name, "srgb(orange)"},
              {SORT_name, "{ param: t, default: red }"},
              {SORT_defined, "{ ref: tint }"},
              {SORT_blend, "{ map: Blend, input: { map: Granite }, blend: [{ input: red }] }"}};
enum { VALUES = sizeof values / sizeof *values, LONGEST_DOCUMENT = 400, VALUE_LINE = 4 };

/* A color in its several forms. */
static bool suits_color(const ParamRow *row, Sort sort)
{
    switch (row->type) {
    case PARAM_Map:
        return sort == SORT_gray || sort == SORT_blend ||
               !param_is_number((int)(row - param_table));
    case PARAM_Float:
        return row->kind == KIND_Constant && sort <= SORT_name;
    case PARAM_Vec3:
        return sort <= SORT_name;
    case PARAM_Formula:
        return sort <= SORT_color;
    default:
        return false;
    }
}

/* Sorts of values that a parameter takes, by the words of docs/reference/language.md. */
static bool suits(const ParamRow *row, Sort sort)
{
    if (sort == SORT_nothing)
        return true;
    if (sort == SORT_number && (1 < row->low || 1 > row->high))
        return false;
    if (sort >= SORT_gray)
        return suits_color(row, sort);
    switch (row->type) {
    case PARAM_Map:
        return sort == SORT_number || sort == SORT_map ||
               (sort == SORT_list &&
                (!row->components || row->components == 3 ||
                 param_is_colored((int)(row - param_table))) &&
                !param_is_number((int)(row - param_table)));
    case PARAM_Material:
        return sort == SORT_material;
    case PARAM_Float:
    case PARAM_Int:
        return sort == SORT_number || (sort == SORT_list && row->kind == KIND_Constant);
    case PARAM_Vec3:
        return sort == SORT_number || sort == SORT_list;
    case PARAM_Bool:
        return sort == SORT_truth;
    case PARAM_Items:
        return sort == SORT_none;
    case PARAM_List:
        return sort == SORT_none || sort == SORT_list;
    case PARAM_Maps:
        return sort == SORT_object;
    case PARAM_Formula:
        return sort == SORT_number;
    default:
        return param_is_word(row) && sort == SORT_truth && word_of_truth(row->type, true) >= 0;
    }
}

/* The errors of a document with the value; its lines from VALUE_LINE on are the parameter's. */
static char *errors_of(const ParamRow *row, const char *value, char text[LONGEST_DOCUMENT])
{
    const char *kind = kind_table[row->kind].name;
    if (kind_table[row->kind].lowering == LOWERING_MATERIAL)
        snprintf(text, LONGEST_DOCUMENT,
                 "materials:\n a:\n  material: %s\n  %s: %s\ndefs: { tint: \"#ff8800\" }\n", kind,
                 row->name, value);
    else
        snprintf(text, LONGEST_DOCUMENT,
                 "defs:\n a:\n  map: %s\n  %s: %s\n tint: \"#ff8800\"\nmaterial: Phong\ndiffuse: { "
                 "ref: a }\n",
                 kind, row->name, value);
    MatcOptions options;
    matc_options_init(&options);
    MatcDocument *document = matc_read("case.yaml", text, strlen(text), &options);
    char *errors = NULL;
    if (matc_error_count(document) > 0) {
        const char *reported = matc_diagnostics(document, MATC_TEXT);
        errors = malloc(strlen(reported) + 1);
        assert_non_null(errors);
        strcpy(errors, reported);
    }
    matc_document_free(document);
    return errors;
}

/* So many lines has the parameter with its value. */
static int lines_of(const char *value)
{
    int lines = 1;
    for (; *value; value++)
        lines += *value == '\n';
    return lines;
}

/* The first error stands within the value, or, what is empty, at its key. */
static bool is_placed(const char *errors, const char *value)
{
    int line, column;
    const char *first = strstr(errors, "case.yaml:");
    return first && strstr(errors, ": error: ") &&
           sscanf(first, "case.yaml:%d:%d", &line, &column) == 2 && line >= VALUE_LINE &&
           line < VALUE_LINE + lines_of(value) && column >= 3;
}

static void wrong_kinds_are_errors_with_a_place(void **state)
{
    (void)state;
    int tried = 0, wrong = 0, faults = 0;
    for (int i = 0; i < PARAM_COUNT; i++)
        for (int k = 0; k < VALUES; k++) {
            char text[LONGEST_DOCUMENT];
            const ParamRow *row = &param_table[i];
            const bool fits = suits(row, values[k].sort);
            if (row->type == PARAM_Material && values[k].sort == SORT_defined)
                continue; /* reported at the definition */
            char *errors = errors_of(row, values[k].text, text);
            tried++;
            wrong += !fits;
            if (!errors != fits || (errors && !is_placed(errors, values[k].text))) {
                faults++;
                print_error("%s\n%s", text, errors ? errors : "no error\n");
            }
            free(errors);
        }
    print_message("%d values, %d of them of a wrong kind\n", tried, wrong);
    assert_true(wrong > tried / 3);
    assert_int_equal(faults, 0);
}

/* Warnings are found by nodes, inputs before their users, and reported by lines; a note stays with
 * what it is of. */
static void warnings_come_by_lines(void **state)
{
    (void)state;
    static const char text[] =
        "defs:\n  far: { map: Checker, input: { map: UVTransform, angle: 90 } }\nmaterials:\n"
        "  a:\n    material: Principled\n    filmThickness: 500\n    metalness: { map: Mix, a: 1, "
        "amount: { ref: far } }\n"
        "    roughness: 20\n    baseColor: { map: Blend }\n  b:\n    material: Phong\n    diffuse: "
        "{ map: HSV, hue: 120, input: { ref: far } }\n"
        "    shininess: 30\n    specular: { map: Blend, input: { map: Wood, input: { map: "
        "XYZTransform, transform: { rotation: [90, 0, 0] } } } }\n";
    MatcOptions options;
    matc_options_init(&options);
    MatcDocument *document = matc_read("case.yaml", text, strlen(text), &options);
    int lines[40], count = 0, line;
    assert_int_equal(matc_error_count(document), 0);
    for (const char *at = matc_diagnostics(document, MATC_TEXT); (at = strstr(at, "case.yaml:"));
         at++) {
        assert_int_equal(sscanf(at, "case.yaml:%d:", &line), 1);
        assert_true(!count || line >= lines[count - 1]);
        lines[count++] = line;
    }
    assert_true(count >= 7 && lines[0] == 2 && lines[count - 1] == 14);
    matc_document_free(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(wrong_kinds_are_errors_with_a_place),
                                       cmocka_unit_test(warnings_come_by_lines)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
