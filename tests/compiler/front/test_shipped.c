/* The definitions of matc's library: each has a description, compiles for old and new targets
 * with its defaults, and gives finite values of moderate size everywhere. */
#include "tests/test.h"
#include "compiler/document.h"
#include "grammar/library_table.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST = 512, POINTS = 40 };

static MatcDocument *read(const char *text)
{
    MatcOptions options;
    matc_options_init(&options);
    MatcDocument *document = matc_read("test.yaml", text, strlen(text), &options);
    if (matc_error_count(document))
        fail_msg("%s\n%s", text, matc_diagnostics(document, MATC_TEXT));
    return document;
}

/* Points near and far, the normal on the unit sphere. */
static void assert_values(const MatcDocument *document, const char *name)
{
    MatcOptions options;
    matc_options_init(&options);
    for (int i = 0; i < POINTS; i++) {
        char point[LONGEST];
        const double size = i % 5 ? 3 : 1000, turn = 2.4 * i, z = 1 - 2 * (i + .5) / POINTS,
                     r = sqrt(1 - z * z);
        snprintf(point, sizeof point, "u=%g v=%g x=%g y=%g z=%g pz=%g nx=%g ny=%g nz=%g",
                 size * sin(3.7 * i), size * cos(2.3 * i), size * sin(1.1 * i), size * sin(1.9 * i),
                 size * cos(.7 * i), 2 * z, r * cos(turn), r * sin(turn), z);
        const MatcNumbers value = matc_eval_slot(document, 0, point, &options);
        assert_null(value.fault);
        for (int component = 0; component < value.components; component++)
            if (!(value.component[component] >= -1e-9 && value.component[component] <= 1.6))
                fail_msg("%s at %s, lane %d: %g", name, point, component,
                         value.component[component]);
    }
}

static void assert_compiles(const MatcDocument *document, const char *name, const char *target)
{
    MatcOptions options;
    matc_options_init(&options);
    options.target = target;
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
    if (!matc_ok(program) || strstr(matc_program_diagnostics(program, MATC_TEXT), "warning"))
        fail_msg("%s, %s: %s", name, target, matc_program_diagnostics(program, MATC_TEXT));
    matc_program_free(program);
}

static void assert_documented(const Member *definition, bool params_too)
{
    const Member *params = tree_find(definition->value, "params");
    assert_true(tree_find(definition->value, "doc") && params);
    for (uint32_t i = 0; params_too && i < params->value->count; i++) {
        const Tree *param = params->value->members[i].value;
        if (param->kind != TREE_object || !tree_find(param, "doc") || !tree_find(param, "default"))
            fail_msg("%s: %s does not say what it is", definition->key,
                     params->value->members[i].key);
    }
}

static void check_file(const LibraryFile *file)
{
    char text[LONGEST];
    snprintf(text, sizeof text, "include: %s\n", file->name);
    MatcDocument *all = read(text);
    const Tree *defs = all->graph->defs[0];
    assert_true(defs->count > 0 &&
                !strncmp(defs->members[0].key, file->name, strlen(file->name) - strlen(".yaml")));
    for (uint32_t i = 0; i < defs->count; i++) {
        const char *name = defs->members[i].key;
        assert_documented(&defs->members[i], i == 0);
        snprintf(text, sizeof text, "include: %s\nmaterial: Phong\ndiffuse: { ref: %s }\n",
                 file->name, name);
        MatcDocument *one = read(text);
        assert_compiles(one, name, "glsl330");
        assert_compiles(one, name, "glsl110");
        assert_values(one, name);
        char *page = matc_explain_definition(one, name);
        assert_true(page && strstr(page, file->name));
        free(page);
        matc_document_free(one);
    }
    matc_document_free(all);
}

static void definitions_are_what_they_say(void **state)
{
    (void)state;
    assert_true(library_count >= 12);
    for (int i = 0; i < library_count; i++)
        check_file(&library_table[i]);
}

/* Its page of docs is of all, and of nothing else. */
static void the_picture_is_of_all(void **state)
{
    (void)state;
    char text[8192];
    MatcOptions options;
    matc_options_init(&options);
    FILE *file = fopen(SOURCE_FOLDER "/docs/pictures/library.yaml", "rb");
    assert_non_null(file);
    const size_t size = fread(text, 1, sizeof text, file);
    fclose(file);
    MatcDocument *document = matc_read("library.yaml", text, size, &options);
    assert_int_equal(matc_error_count(document), 0);
    assert_int_equal(matc_material_count(document), library_count);
    for (int i = 0; i < library_count; i++) {
        char name[64];
        snprintf(name, sizeof name, "%.*s", (int)(strlen(library_table[i].name) - strlen(".yaml")),
                 library_table[i].name);
        assert_true(matc_material_find(document, name) >= 0);
    }
    matc_document_free(document);
}

/* wornEdges goes by the slope of a height, not by how high it is: 20 u tilts a normal by 58
 * degrees. */
static void edges_are_worn_where_steep(void **state)
{
    (void)state;
    static const struct {
        const char *height;
        double shown; /* what is below */
    } cases[] = {{"20", 0}, {"20 * u", 1}, {"-20 * v", 1}, {"u < .5 ? u : 20 * u", 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[LONGEST], shown[64];
        const char *fault = NULL;
        snprintf(text, sizeof text,
                 "include: worn.yaml\nmaterial: Phong\ndiffuse: { ref: wornEdges, coat: 0, under: "
                 "1, height: \"= %s\", "
                 "size: 0.01 }\n",
                 cases[i].height);
        MatcDocument *document = read(text);
        MatcOptions options;
        matc_options_init(&options);
        char *values = matc_eval(document, 0, "u=.3 v=.2 x=.1 y=.5", &options, &fault);
        assert_non_null(values);
        snprintf(shown, sizeof shown, "\ndiffuse %.1f %.1f %.1f\n", cases[i].shown, cases[i].shown,
                 cases[i].shown);
        if (!strstr(values, shown))
            fail_msg("%s: %s", cases[i].height, values);
        free(values);
        matc_document_free(document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(definitions_are_what_they_say),
                                       cmocka_unit_test(the_picture_is_of_all),
                                       cmocka_unit_test(edges_are_worn_where_steep)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
