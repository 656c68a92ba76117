/* Pairs of inputs from tests/near_misses.def: one causes a message, the other nearly does and
 * must cause no message at all. A message without a row fails. */
#include "runtime/scene_reader/scene_read.h"
#include "tests/test.h"
#include "compiler/base/diag.h"
#include "compiler/base/file.h"
#include "compiler/matc.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef enum { OF_DOCUMENT, OF_LAYOUT, OF_SCENE, OF_OPTIONS, IN_FILE, NOWHERE } RowOf;
typedef struct {
    DiagKind kind;
    RowOf of;
    const char *trigger, *miss; /* IN_FILE: the file and a text in it */
    unsigned outputs;           /* OF_OPTIONS */
} Row;

static const Row rows[] = {
#define NEAR(kind, trigger, miss)        {DIAG_##kind, OF_DOCUMENT, trigger, miss, 0},
#define NEAR_LAYOUT(kind, trigger, miss) {DIAG_##kind, OF_LAYOUT, trigger, miss, 0},
#define NEAR_SCENE(kind, trigger, miss)  {DIAG_##kind, OF_SCENE, trigger, miss, 0},
#define NEAR_OPTIONS(kind, outputs, trigger, miss)                                                 \
    {DIAG_##kind, OF_OPTIONS, trigger, miss, outputs},
#define NEAR_IN(kind, file, text) {DIAG_##kind, IN_FILE, file, text, 0},
#define NO_NEAR(kind, why)        {DIAG_##kind, NOWHERE, why, NULL, 0},
#include "tests/near_misses.def"
#undef NEAR
#undef NEAR_LAYOUT
#undef NEAR_SCENE
#undef NEAR_OPTIONS
#undef NEAR_IN
#undef NO_NEAR
};
enum { ROWS = sizeof rows / sizeof *rows, MAX_TEXT_BYTES = 1 << 16 };

static void add(char *out, const char *text)
{
    const size_t size = strlen(out);
    snprintf(out + size, MAX_TEXT_BYTES - size, "%s", text);
}

/* Appends all diagnostics of a document and of its materials, which are compiled. */
static void document_messages(const char *text, unsigned outputs, char *out)
{
    MatcOptions options;
    matc_options_init(&options);
    options.validate = false;
    (void)outputs;
    options.warnings = "linear_colors";
    MatcDocument *document =
        matc_read(*text == '{' && !strchr(text, '\n') ? "examples/near.json" : "examples/near.yaml",
                  text, strlen(text), &options);
    *out = 0;
    add(out, matc_diagnostics(document, MATC_JSON));
    for (int i = 0; i < matc_material_count(document); i++) {
        MatcProgram *program = matc_compile(document, i, MATC_FRAGMENT, &options);
        add(out, matc_program_diagnostics(program, MATC_JSON));
        matc_program_free(program);
    }
    matc_document_free(document);
}

/* Appends all diagnostics of a layout, and of a Phong that is compiled with it. */
static void layout_messages(const char *text, unsigned outputs, char *out)
{
    static const char material[] = "material: Phong\ndiffuse: 0.5\nspecular: 0.3\nshininess: 0.5\n";
    MatcOptions options;
    matc_options_init(&options);
    options.validate = false;
    (void)outputs;
    MatcLayout *layout = matc_layout_read("near.yaml", text, strlen(text), &options);
    *out = 0;
    add(out, matc_layout_diagnostics(layout, MATC_JSON));
    if (matc_layout_ok(layout)) {
        options.custom = layout;
        MatcDocument *document = matc_read("near.yaml", material, sizeof material - 1, &options);
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
        add(out, matc_program_diagnostics(program, MATC_JSON));
        matc_program_free(program);
        matc_document_free(document);
    }
    matc_layout_free(layout);
}

static void scene_messages(const char *text, unsigned outputs, char *out)
{
    Scene *scene = NULL;
    MatcOptions options;
    matc_options_init(&options);
    (void)outputs;
    options.warnings = "no-no_light";
    MatcDocument *document = scene_read("near.yaml", text, strlen(text), &options, &scene);
    *out = 0;
    add(out, matc_diagnostics(document, MATC_JSON));
    if (scene)
        scene_free(scene);
    matc_document_free(document);
}

/* Appends all diagnostics of a Phong under options such as "target=glsl110 layout=integer". */
static void options_messages(const char *text, unsigned outputs, char *out)
{
    static const char material[] = "material: Phong\ndiffuse: 0.5\n";
    char words[128], *at = words;
    MatcOptions options;
    matc_options_init(&options);
    options.validate = false;
    snprintf(words, sizeof words, "%s", text);
    for (char *word; (word = strtok_r(at, " ", &at));) {
        char *value = strchr(word, '=');
        *value++ = 0;
        assert_true(matc_options_set(&options, word, value));
    }
    MatcDocument *document = matc_read("near.yaml", material, sizeof material - 1, &options);
    MatcProgram *program = matc_compile(document, 0, outputs, &options);
    *out = 0;
    add(out, matc_program_diagnostics(program, MATC_JSON));
    matc_program_free(program);
    matc_document_free(document);
}

static bool stands_in(const Row *row)
{
    size_t size;
    const char *why;
    char *text = file_read(row->trigger, &size, &why);
    const bool found = text && strstr(text, row->miss);
    free(text);
    return found;
}

static int check_row(const Row *row, char *out)
{
    char kind[128];
    const char *name = diag_table[row->kind].name;
    static void (*const all[])(const char *, unsigned, char *) = {
        document_messages, layout_messages, scene_messages, options_messages};
    if (row->of == NOWHERE)
        return 0;
    if (row->of == IN_FILE) {
        const bool found = stands_in(row);
        if (!found)
            print_error("%s: \"%s\" does not stand in %s\n", name, row->miss, row->trigger);
        return !found;
    }
    snprintf(kind, sizeof kind, "\"kind\": \"%s\"", name);
    all[row->of](row->trigger, row->outputs, out);
    const bool reported = strstr(out, kind) != NULL;
    if (!reported)
        print_error("%s is not reported of\n%s%s\n", name, row->trigger, out);
    all[row->of](row->miss, row->outputs, out);
    if (*out)
        print_error("%s: the near miss is not silent:\n%s%s\n", name, row->miss, out);
    return !reported + (*out != 0);
}

static void messages_and_near_misses(void **state)
{
    static char out[MAX_TEXT_BYTES];
    int faults = 0;
    (void)state;
    for (int i = 0; i < ROWS; i++)
        faults += check_row(&rows[i], out);
    assert_int_equal(faults, 0);
}

/* Compiling a Phong with these options reports the kind. */
static bool reports_of(const MatcOptions *options, unsigned outputs, DiagKind kind)
{
    static const char material[] = "material: Phong\ndiffuse: [0.2, 0.3, 0.4]\n";
    MatcDocument *document = matc_read("near.yaml", material, sizeof material - 1, NULL);
    MatcProgram *program = matc_compile(document, 0, outputs, options);
    const bool found =
        strstr(matc_program_diagnostics(program, MATC_JSON), diag_table[kind].name) != NULL;
    matc_program_free(program);
    matc_document_free(document);
    return found;
}

static bool reports(const MatcOptions *options, DiagKind kind)
{
    return reports_of(options, MATC_FRAGMENT, kind);
}

/* Faults that only a caller can cause: options that matc_options_set rejects, a wrong number of
 * members, unknown outputs, a layout for no materials. */
static void faults_of_callers(void **state)
{
    MatcOptions options;
    MatcRanges ranges;
    (void)state;
    matc_options_init(&options);
    options.target = "glsl331";
    assert_true(reports(&options, DIAG_unknown_option));
    options.target = "glsl330";
    assert_false(reports(&options, DIAG_unknown_option));
    const int members[1] = {0};
    options.members = members;
    options.member_count = 1;
    assert_true(reports(&options, DIAG_wrong_members));
    options.member_count = 0;
    assert_false(reports(&options, DIAG_wrong_members));
    assert_true(reports_of(&options, 1u << 30, DIAG_unknown_output));
    assert_false(reports_of(&options, MATC_COMPUTE, DIAG_unknown_output));
    matc_ranges_init(&ranges);
    MatcLayout *layout = matc_layout_for(&ranges, 1, NULL);
    assert_non_null(
        strstr(matc_layout_diagnostics(layout, MATC_JSON), diag_table[DIAG_layout_of_none].name));
    assert_null(
        strstr(matc_layout_diagnostics(layout, MATC_JSON), diag_table[DIAG_layout_error].name));
    matc_layout_free(layout);
    layout = matc_layout_for(&ranges, 1.01, NULL);
    assert_non_null(
        strstr(matc_layout_diagnostics(layout, MATC_JSON), diag_table[DIAG_layout_error].name));
    matc_layout_free(layout);
}

static void every_message_has_a_row(void **state)
{
    int missing = 0;
    (void)state;
    for (int kind = 0; kind < DIAG_COUNT; kind++) {
        int found = 0;
        for (int i = 0; i < ROWS; i++)
            found += (int)rows[i].kind == kind;
        if (!found)
            print_error("tests/near_misses.def has no row of %s\n", diag_table[kind].name);
        missing += !found;
    }
    assert_int_equal(missing, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(messages_and_near_misses),
                                       cmocka_unit_test(faults_of_callers),
                                       cmocka_unit_test(every_message_has_a_row)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
