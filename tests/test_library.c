/* The library: options, several materials, textures, uniforms, threads, and that no fault is silent. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "compiler/matc.h"
#include "grammar/tables.h"
#include <cjson/cJSON.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static MatcOptions quick(void)
{
    MatcOptions options;
    matc_options_init(&options);
    options.validate = false;
    options.check = true;
    return options;
}

static MatcDocument *read_text(const char *text, const MatcOptions *options)
{
    return matc_read("test.yaml", text, strlen(text), options);
}

static char *compile_text(const char *text, unsigned output, const MatcOptions *options)
{
    MatcDocument *document = read_text(text, options);
    MatcProgram *program = matc_compile(document, 0, output, options);
    if (!matc_ok(program))
        fprintf(stderr, "%s%s", matc_diagnostics(document, MATC_TEXT), matc_program_diagnostics(program, MATC_TEXT));
    assert_true(matc_ok(program));
    char *result = strdup(matc_output(program, (MatcOutput)output, NULL));
    matc_program_free(program);
    matc_document_free(document);
    return result;
}

static const char *const checker = "material: Phong\n"
                                   "diffuse: { map: Checker, color1: 0.3, color2: { map: Granite } }\n"
                                   "specular: { map: Granite }\n";

static int count(const char *text, const char *word)
{
    int n = 0;
    for (const char *at = text; (at = strstr(at, word)); at += strlen(word))
        n++;
    return n;
}

static void equal_subtrees_are_computed_once(void **state)
{
    (void)state;
    MatcOptions options = quick();
    char *text = compile_text(checker, MATC_FRAGMENT, &options);
    assert_int_equal(count(text, "granite(localPosition)"), 1);
    free(text);
}

static void a_filter_is_one_function(void **state)
{
    (void)state;
    MatcOptions options = quick();
    char *one =
        compile_text("material: Phong\ndiffuse: { map: Smooth3D, input: { map: Wood } }\n", MATC_FRAGMENT, &options);
    assert_int_equal(count(one, "smooth3DInput0("), 1 + 27); /* the definition and the calls */
    assert_int_equal(count(one, "wood(p)"), 1);
    char *two =
        compile_text("material: Phong\ndiffuse: { map: Smooth3D, input: { map: Smooth3D, input: { map: Wood } } }\n",
                     MATC_FRAGMENT, &options);
    assert_int_equal(count(two, "wood(p)"), 1);
    assert_int_equal(count(two, "smooth3DInput0("), 1 + 27);
    assert_int_equal(count(two, "smooth3DInput1"),
                     2 + 2); /* itself costly: it and its sum, a loop, each defined and called once */
    free(one);
    free(two);
}

/* A subtree that cannot matter leaves no trace. */
static void dead_parts_are_pruned(void **state)
{
    (void)state;
    static const char *const documents[] = {
        "material: Phong\ndiffuse: { map: Blend, input: 5, blend: [{ input: { map: Granite } }, { value: 1 }] }\n",
        "material: Phong\ndiffuse: { map: Checker, color1: 0.5, color2: 0.5, input: { map: Turbulence } }\n",
        "material: Phong\nambient: { map: Granite }\n", /* thesis has no ambient */
        "material: SideSwitch\nfrontShader: { material: RGBA }\nbackShader: { material: RGBA }\n"};
    MatcOptions options = quick();
    options.layout = "thesis";
    for (size_t i = 0; i < sizeof documents / sizeof *documents; i++) {
        char *text = compile_text(documents[i], MATC_FRAGMENT, &options);
        assert_null(strstr(text, "granite"));
        assert_null(strstr(text, "urbulence"));
        assert_null(strstr(text, "uv"));
        free(text);
    }
}

static void costly_arms_are_branches(void **state)
{
    (void)state;
    MatcOptions options = quick();
    char *text = compile_text("material: Phong\ndiffuse: { map: Checker, color1: { map: Granite }, color2: 0.5 }\n",
                              MATC_FRAGMENT, &options);
    const char *branch = strstr(text, "if ("), *call = strstr(text, "= granite(localPosition)");
    assert_non_null(branch);
    assert_non_null(call);
    assert_true(branch < call);
    free(text);
    text =
        compile_text("material: Phong\ndiffuse: { map: Checker, color1: 0.1, color2: 0.5 }\n", MATC_FRAGMENT, &options);
    assert_null(strstr(text, "if ("));
    free(text);
}

static void inputs_are_minimal(void **state)
{
    (void)state;
    MatcOptions options = quick();
    options.pass = "shadow";
    char *text = compile_text("material: Phong\ndiffuse: { map: Granite }\n", MATC_FRAGMENT, &options);
    assert_null(strstr(text, "in vec"));
    assert_null(strstr(text, "discard"));
    free(text);
    text = compile_text("material: Phong\ntransparency: { map: Checker }\n", MATC_FRAGMENT, &options);
    assert_non_null(strstr(text, "discard"));
    assert_int_equal(count(text, "\nin "), 1);
    free(text);
}

static void materials_are_listed(void **state)
{
    (void)state;
    MatcOptions options = quick();
    MatcDocument *document = read_text("materials:\n  a: { material: RGBA }\n  b: { material: Phong }\n", &options);
    assert_int_equal(matc_material_count(document), 2);
    assert_string_equal(matc_material_name(document, 1), "b");
    assert_int_equal(matc_material_find(document, "b"), 1);
    assert_int_equal(matc_material_find(document, "c"), -1);
    MatcProgram *program = matc_compile(document, 7, MATC_FRAGMENT, &options);
    assert_false(matc_ok(program));
    assert_null(matc_output(program, MATC_FRAGMENT, NULL));
    matc_program_free(program);
    matc_document_free(document);
}

static void uniforms_have_defaults(void **state)
{
    (void)state;
    MatcOptions options = quick();
    MatcDocument *document = read_text("material: Phong\ndiffuse: { param: tint, default: [1, 0.5, 0.25] }\n"
                                       "specular: { map: Julia, iterations: { param: steps, default: 12 } }\n",
                                       &options);
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
    assert_int_equal(matc_uniform_count(program), 2);
    MatcUniform tint = *matc_uniform(program, 0), steps = *matc_uniform(program, 1);
    assert_string_equal(tint.name, "tint");
    assert_int_equal(tint.lanes, 3);
    assert_true(tint.initial[1] == 0.5 && !tint.whole);
    assert_true(steps.whole && steps.initial[0] == 12);
    assert_non_null(strstr(matc_output(program, MATC_FRAGMENT, NULL), "uniform int steps;"));
    matc_program_free(program);
    matc_document_free(document);
}

static void noise_tables_are_textures(void **state)
{
    (void)state;
    MatcOptions options = quick();
    options.noise = "groimp";
    options.target = "glsl110";
    MatcDocument *document = read_text("material: Phong\ndiffuse: { map: Granite }\n", &options);
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
    assert_int_equal(matc_texture_count(program), 3);
    MatcTexture permutation = *matc_texture(program, 0);
    assert_string_equal(permutation.name, "matc_permutation");
    assert_true(permutation.floats[0] == 45307 && permutation.floats[65535] == 54233);
    matc_program_free(program);
    matc_document_free(document);
}

/* The reflection is JSON, and names every uniform and texture that the shader declares. */
static void reflection_fits_the_shader(void **state)
{
    (void)state;
    static const char text[] = "material: Phong\n"
                               "input: { map: BumpMap, displacement: { map: Carpenter } }\n"
                               "diffuse: { map: Granite, frequency: { param: fast, default: 2 } }\n"
                               "specular: { param: tint, default: [1, 0.5, 0.25] }\n";
    for (int i = 0; i < TARGET_COUNT; i++) {
        MatcOptions options = quick();
        options.target = target_table[i].name;
        options.noise = "groimp";
        char *json = compile_text(text, MATC_REFLECT, &options), *shader = compile_text(text, MATC_FRAGMENT, &options);
        cJSON *root = cJSON_Parse(json), *list, *item;
        assert_non_null(root);
        static const char *const lists[] = {"inputs", "uniforms", "textures"};
        for (int k = 0; k < 3; k++) {
            list = cJSON_GetObjectItem(root, lists[k]);
            assert_true(cJSON_GetArraySize(list) > 1);
            cJSON_ArrayForEach(item, list)
                assert_non_null(strstr(shader, cJSON_GetObjectItem(item, "name")->valuestring));
        }
        item = cJSON_GetObjectItem(root, "choices");
        assert_true(cJSON_GetArraySize(item) >= 6); /* noise ... trigonometry */
        assert_string_equal(cJSON_GetObjectItem(item, "noise")->valuestring, "groimp");
        assert_string_equal(cJSON_GetObjectItem(item, "aa")->valuestring, "auto");
        assert_non_null(strstr(shader, "// choices: noise=groimp\n"));
        item = cJSON_GetObjectItem(cJSON_GetObjectItem(root, "block"), "size");
        assert_true(target_table[i].locations ? item->valueint == 80
                                              : item == NULL); /* float, vec3 at 16, mat3 at 32 */
        cJSON_Delete(root);
        free(json);
        free(shader);
    }
}

/* Every option that takes one of a few names, and those names as matc.h has them. */
static const struct {
    const char *option, *values;
} named_options[] = {
    {"target", "glsl110, glsl330, glsl450, essl300, spirv"},
    {"pass", "gbuffer, plane, sky, shadow, depth, value"},
    {"slot",
     "normal, diffuse, alpha, specular, shininess, transparency, transparencyShininess, interpolatedTransparency, "
     "diffuseTransparency, ambient, emissive, ior"},
    {"layout", "thesis, radix, thin, integer, compact"},
    {"precision", "fast, balanced, exact"},
    {"noise", "lattice, groimp, simplex"},
    {"aa", "auto, none, box, aniso"},
    {"derivatives", "auto, finite, analytic"},
    {"coordinates", "plain, long"},
    {"powers", "squaring, pow, compensated"},
    {"trigonometry", "native, bounded"},
    {"constants", "auto, baked, uniform"},
    {"normals", "eye, world"},
};
enum { NAMED_OPTIONS = sizeof named_options / sizeof *named_options };

static void every_value_of_an_option_is_taken(void **state)
{
    (void)state;
    for (int i = 0; i < NAMED_OPTIONS; i++) {
        char values[256], *rest;
        snprintf(values, sizeof values, "%s", named_options[i].values);
        for (char *value = strtok_r(values, ", ", &rest); value; value = strtok_r(NULL, ", ", &rest)) {
            MatcOptions options = quick();
            assert_true(matc_options_set(&options, named_options[i].option, value));
            assert_null(matc_options_fault(&options));
        }
    }
    for (int axis = 0; axis < AXIS_COUNT; axis++) { /* none is left out above */
        int rows = 0;
        for (int i = 0; i < NAMED_OPTIONS; i++)
            rows += !strcmp(named_options[i].option, axis_table[axis].name);
        assert_int_equal(rows, 1);
    }
}

/* The members that hold names, which the caller may have set to anything. */
static void put_value(MatcOptions *options, const char *option, const char *value)
{
    const struct {
        const char *option;
        const char **member;
    } members[] = {{"target", &options->target},
                   {"pass", &options->pass},
                   {"slot", &options->slot},
                   {"layout", &options->layout},
                   {"precision", &options->precision},
                   {"noise", &options->noise},
                   {"aa", &options->aa},
                   {"derivatives", &options->derivatives},
                   {"coordinates", &options->coordinates},
                   {"powers", &options->powers},
                   {"trigonometry", &options->trigonometry},
                   {"constants", &options->constants},
                   {"normals", &options->normals}};
    for (size_t i = 0; i < sizeof members / sizeof *members; i++)
        if (!strcmp(members[i].option, option))
            *members[i].member = value;
}

/* None is set by its name, and a program that has one all the same says which values there are. */
static void unknown_values_are_refused(void **state)
{
    (void)state;
    static const char *const unknown[] = {"nonsense", "", "Auto", "none,box", "fast "};
    for (int i = 0; i < NAMED_OPTIONS * 5; i++) {
        const char *option = named_options[i / 5].option, *value = unknown[i % 5];
        MatcOptions options = quick();
        MatcDocument *document = read_text(checker, &options);
        assert_false(matc_options_set(&options, option, value));
        assert_null(matc_options_fault(&options));
        put_value(&options, option, value);
        assert_string_equal(matc_options_fault(&options), option);
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
        char want[512];
        snprintf(want, sizeof want, "error: %s: there is no '%s', but %s", option, value, named_options[i / 5].values);
        assert_false(matc_ok(program));
        if (!strstr(matc_program_diagnostics(program, MATC_TEXT), want))
            fail_msg("'%s' is wanted, not '%s'", want, matc_program_diagnostics(program, MATC_TEXT));
        matc_program_free(program);
        matc_document_free(document);
    }
    MatcOptions options = quick();
    assert_false(matc_options_set(&options, "nonsense", "auto"));
    assert_false(matc_options_set(&options, "optimize", "2"));
}

/* A program that was compiled with fewer options: what lies behind its struct is not touched, what it lacks has its default. */
static void older_options_work(void **state)
{
    (void)state;
    enum { KNOWN = offsetof(MatcOptions, optimize) };
    union {
        MatcOptions options;
        unsigned char bytes[sizeof(MatcOptions)];
    } old;
    memset(old.bytes, 0xaa, sizeof old.bytes);
    matc_options_init_sized(&old.options, KNOWN);
    assert_true(matc_options_set(&old.options, "pass", "shadow"));
    for (size_t i = KNOWN; i < sizeof old.bytes; i++)
        assert_int_equal(old.bytes[i], 0xaa);
    assert_null(matc_options_fault(&old.options));
    char *text = compile_text(checker, MATC_FRAGMENT, &old.options);
    MatcOptions now;
    matc_options_init(&now);
    now.pass = "shadow";
    char *same = compile_text(checker, MATC_FRAGMENT, &now);
    assert_string_equal(text, same);
    free(text);
    free(same);
    old.options.size = offsetof(MatcOptions, pass);
    assert_false(matc_options_set(&old.options, "pass", "sky"));
}

/* And one that was compiled with more. */
static void newer_options_work(void **state)
{
    (void)state;
    struct {
        MatcOptions options;
        long more[4];
    } newer;
    memset(&newer, 0xaa, sizeof newer);
    matc_options_init_sized(&newer.options, sizeof newer);
    assert_int_equal(newer.options.size, sizeof newer);
    assert_int_equal(newer.more[3], 0);
    free(compile_text(checker, MATC_FRAGMENT, &newer.options));
    assert_string_equal(matc_version(), MATC_VERSION);
}

/* Every cut of a document is either read or refused with a place; nothing else happens. */
static void cut_documents_are_refused(void **state)
{
    (void)state;
    MatcOptions options = quick();
    for (size_t size = 0; size <= strlen(checker); size++) {
        MatcDocument *document = matc_read("cut.yaml", checker, size, &options);
        assert_true(matc_material_count(document) || matc_error_count(document));
        matc_document_free(document);
    }
}

static void evaluation_reads_back(void **state)
{
    (void)state;
    const char *fault;
    MatcOptions options = quick();
    MatcDocument *document = read_text("material: Phong\ndiffuse: [0.1, 0.2, 0.30000000000000004]\n", &options);
    char *values = matc_eval(document, 0, "u=0.5 v=1e-3", &options, &fault);
    assert_non_null(values);
    assert_non_null(strstr(values, "diffuse 0.1 0.2 0.30000000000000004\n"));
    assert_non_null(strstr(values, "normal 0.0 0.0 1.0\n"));
    free(values);
    assert_null(matc_eval(document, 0, "u=half", &options, &fault));
    assert_null(matc_eval(document, 0, "colour=1", &options, &fault));
    assert_null(matc_eval(document, 3, "u=1", &options, &fault));
    matc_document_free(document);
}

/* What matc.h promises: none is "", and no empty array that somebody would compare with. */
static void no_diagnostics_are_no_text(void **state)
{
    (void)state;
    MatcOptions options = quick();
    MatcDocument *document = matc_read("x.yaml", "material: Phong\n", 16, &options);
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
    for (int form = MATC_TEXT; form <= MATC_JSON; form++) {
        assert_string_equal(matc_diagnostics(document, (MatcForm)form), "");
        assert_string_equal(matc_program_diagnostics(program, (MatcForm)form), "");
    }
    matc_program_free(program);
    matc_document_free(document);
}

typedef struct {
    const MatcDocument *document;
    const char *expected;
    int wrong;
} Job;

static void *compile_often(void *user)
{
    Job *job = user;
    MatcOptions options = quick();
    options.validate = true;
    for (int i = 0; i < 20; i++) {
        MatcProgram *program = matc_compile(job->document, 0, MATC_FRAGMENT, &options);
        job->wrong += !matc_ok(program) || strcmp(matc_output(program, MATC_FRAGMENT, NULL), job->expected) != 0;
        matc_program_free(program);
    }
    return NULL;
}

static void threads_share_a_document(void **state)
{
    (void)state;
    enum { THREADS = 4 };
    MatcOptions options = quick();
    char *expected = compile_text(checker, MATC_FRAGMENT, &options);
    MatcDocument *document = read_text(checker, &options);
    pthread_t threads[THREADS];
    Job jobs[THREADS];
    for (int i = 0; i < THREADS; i++) {
        jobs[i] = (Job){document, expected, 0};
        assert_int_equal(pthread_create(&threads[i], NULL, compile_often, &jobs[i]), 0);
    }
    for (int i = 0; i < THREADS; i++) {
        pthread_join(threads[i], NULL);
        assert_int_equal(jobs[i].wrong, 0);
    }
    matc_document_free(document);
    free(expected);
}

/* A chain of n maps through references, deeper than any nesting of the text. */
static char *chain(int n)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    fputs("defs:\n  m0: &m0 { map: Wood }\n", out);
    for (int i = 1; i < n; i++)
        fprintf(out, "  m%d: &m%d { map: UVTransform, input: *m%d }\n", i, i, i - 1);
    fprintf(out, "material: Phong\ndiffuse: *m%d\n", n - 1);
    fclose(out);
    return text;
}

static void deep_chains_are_bounded(void **state)
{
    (void)state;
    MatcOptions options = quick();
    static const int sizes[] = {200, 5000, 100000};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        char *text = chain(sizes[i]);
        MatcDocument *document = read_text(text, &options);
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
        assert_true(matc_ok(program) || matc_error_count(document));
        assert_true(sizes[i] > 200 || matc_ok(program));
        matc_program_free(program);
        matc_document_free(document);
        free(text);
    }
}

/* Long lists: an ordered one is searched by halving, so neither the shader nor the compiler nests deeply. */
static void long_blends_are_searched(void **state)
{
    (void)state;
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    fputs("material: Phong\ndiffuse:\n  map: Blend\n  input: { map: Granite }\n  blend:\n", out);
    for (int i = 0; i < 3000; i++)
        fprintf(out, "  - { value: %d, input: { map: Wood, frequency: %d } }\n", i, i);
    fclose(out);
    for (int level = 0; level <= 2; level += 2) {
        MatcOptions options = quick();
        options.optimize = level;
        options.validate = true;
        free(compile_text(text, MATC_FRAGMENT, &options));
    }
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_subtrees_are_computed_once),
        cmocka_unit_test(a_filter_is_one_function),
        cmocka_unit_test(dead_parts_are_pruned),
        cmocka_unit_test(costly_arms_are_branches),
        cmocka_unit_test(inputs_are_minimal),
        cmocka_unit_test(materials_are_listed),
        cmocka_unit_test(uniforms_have_defaults),
        cmocka_unit_test(noise_tables_are_textures),
        cmocka_unit_test(reflection_fits_the_shader),
        cmocka_unit_test(every_value_of_an_option_is_taken),
        cmocka_unit_test(unknown_values_are_refused),
        cmocka_unit_test(older_options_work),
        cmocka_unit_test(newer_options_work),
        cmocka_unit_test(cut_documents_are_refused),
        cmocka_unit_test(evaluation_reads_back),
        cmocka_unit_test(no_diagnostics_are_no_text),
        cmocka_unit_test(threads_share_a_document),
        cmocka_unit_test(deep_chains_are_bounded),
        cmocka_unit_test(long_blends_are_searched),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
