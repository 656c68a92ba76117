/* The library's use by programs: several materials, textures, uniforms, threads; every fault is
 * reported. */
#include "tests/test.h"
#include "compiler/base/session.h"
#include "grammar/tables.h"
#include "tests/compile_text.h"
#include <cjson/cJSON.h>
#include <pthread.h>

static void materials_are_listed(void **state)
{
    (void)state;
    MatcOptions options = quick();
    MatcDocument *document =
        read_text("materials:\n  a: { material: RGBA }\n  b: { material: Phong }\n", &options);
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
    MatcDocument *document =
        read_text("material: Phong\ndiffuse: { param: tint, default: [1, 0.5, 0.25] }\n"
                  "specular: { map: Julia, iterations: { param: steps, default: 12 } }\n",
                  &options);
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
    assert_int_equal(matc_uniform_count(program), 2);
    MatcUniform tint = *matc_uniform(program, 0), steps = *matc_uniform(program, 1);
    assert_string_equal(tint.name, "tint");
    assert_int_equal(tint.components, 3);
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
        char *json = compile_text(text, MATC_REFLECT, &options),
             *shader = compile_text(text, MATC_FRAGMENT, &options);
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

/* Every truncation of a document is either read or refused with a place. */
static void cut_documents_are_refused(void **state)
{
    (void)state;
    MatcOptions options = quick();
    for (size_t size = 0; size <= strlen(checker_text); size++) {
        MatcDocument *document = matc_read("cut.yaml", checker_text, size, &options);
        assert_true(matc_material_count(document) || matc_error_count(document));
        matc_document_free(document);
    }
}

static void evaluation_reads_back(void **state)
{
    (void)state;
    const char *fault;
    MatcOptions options = quick();
    MatcDocument *document =
        read_text("material: Phong\ndiffuse: [0.1, 0.2, 0.30000000000000004]\n", &options);
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

static void a_slot_is_evaluated_as_numbers(void **state)
{
    (void)state;
    MatcOptions options = quick();
    MatcDocument *document = read_text(
        "material: Phong\ndiffuse: [0.1, 0.2, 0.30000000000000004]\nshininess: 0.7\n", &options);
    MatcNumbers numbers = matc_eval_slot(document, 0, "", &options);
    assert_null(numbers.fault);
    assert_int_equal(numbers.components, 3);
    assert_true(numbers.component[0] == 0.1 && numbers.component[1] == 0.2 &&
                numbers.component[2] == 0.30000000000000004);
    options.slot = "normal";
    numbers = matc_eval_slot(document, 0, "u=0.5 front=0", &options);
    assert_true(numbers.components == 3 && numbers.component[2] == -1);
    options.slot = "alpha";
    numbers = matc_eval_slot(document, 0, "", &options);
    assert_true(numbers.components == 1 && numbers.component[0] == 1);
    numbers = matc_eval_slot(document, 0, "u=half", &options);
    assert_non_null(numbers.fault);
    assert_int_equal(numbers.components, 0);
    options.slot = "colour";
    assert_non_null(matc_eval_slot(document, 0, "", &options).fault);
    options.slot = NULL;
    assert_non_null(matc_eval_slot(document, 3, "", &options).fault);
    matc_document_free(document);
}

/* As matc.h promises, no diagnostics are "", and no empty array that a host would compare with. */
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
        job->wrong += !matc_ok(program) ||
                      strcmp(matc_output(program, MATC_FRAGMENT, NULL), job->expected) != 0;
        matc_program_free(program);
    }
    return NULL;
}

static void threads_share_a_document(void **state)
{
    (void)state;
    enum { THREADS = 4 };
    MatcOptions options = quick();
    char *expected = compile_text(checker_text, MATC_FRAGMENT, &options);
    MatcDocument *document = read_text(checker_text, &options);
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

/* Waves nested too deep to resolve, next to maps of exactly the allowed depth: only the waves
 * are reported. */
static void what_is_too_deep_leaves_its_neighbours_their_depth(void **state)
{
    (void)state;
    enum { DEPTH = LIMIT_DEPTH - 1 }; /* of the maps: the material is the one above them */
    char *text = NULL;
    size_t size;
    MatcOptions options = quick();
    FILE *out = open_memstream(&text, &size);
    fputs("defs:\n  w0: &w0 Sin\n  m0: &m0 { map: Wood }\n", out);
    for (int i = 1; i <= LIMIT_DEPTH; i++)
        fprintf(out, "  w%d: &w%d { wave: Chain, first: *w%d }\n", i, i, i - 1);
    for (int i = 1; i < DEPTH; i++)
        fprintf(out, "  m%d: &m%d { map: UVTransform, input: *m%d }\n", i, i, i - 1);
    fprintf(out, "material: Phong\nspecular: { map: Gradient, waveForm: *w%d }\ndiffuse: *m%d\n",
            LIMIT_DEPTH, DEPTH - 1);
    fclose(out);
    MatcDocument *document = read_text(text, &options);
    assert_int_equal(matc_material_count(document), 0);
    const char *reported = matc_diagnostics(document, MATC_TEXT),
               *first = strstr(reported, "nested deeper than");
    assert_non_null(first);
    assert_null(strstr(first + 1, "nested deeper than"));
    matc_document_free(document);
    free(text);
}

/* Long lists: an ordered one is searched by halving, so neither the shader nor the compiler nests
 * deeply. */
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
        cmocka_unit_test(materials_are_listed),
        cmocka_unit_test(uniforms_have_defaults),
        cmocka_unit_test(noise_tables_are_textures),
        cmocka_unit_test(reflection_fits_the_shader),
        cmocka_unit_test(cut_documents_are_refused),
        cmocka_unit_test(evaluation_reads_back),
        cmocka_unit_test(a_slot_is_evaluated_as_numbers),
        cmocka_unit_test(no_diagnostics_are_no_text),
        cmocka_unit_test(threads_share_a_document),
        cmocka_unit_test(deep_chains_are_bounded),
        cmocka_unit_test(what_is_too_deep_leaves_its_neighbours_their_depth),
        cmocka_unit_test(long_blends_are_searched),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
