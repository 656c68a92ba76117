/* SPIR-V of all stages: one entry point each, of the right kind; the inputs of a stage match the
 * outputs of the previous stage in location and type; bindings are of set 0, equal in all
 * stages, and those that the reflection names. spirv-val validates them, where installed. */
/* ctest: seconds=16 */
#include "tests/test.h"
#include "compiler/matc.h"
#include "tests/value/read_whole.h"
#include "tests/value/spirv.h"
#include <cjson/cJSON.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MAX_STAGES = 4 };

/* Stages that are drawn together, in their order. */
typedef struct {
    MatcOutput output[MAX_STAGES];
    int model[MAX_STAGES], count;
} MaterialSet;
static const MaterialSet sets[] = {
    {{MATC_VERTEX, MATC_FRAGMENT}, {0, 4}, 2},
    {{MATC_TESSVERTEX, MATC_TESSCONTROL, MATC_TESSEVAL, MATC_FRAGMENT}, {0, 1, 2, 4}, 4},
    {{MATC_GEOMETRYVERTEX, MATC_GEOMETRY, MATC_FRAGMENT}, {0, 3, 4}, 3},
    {{MATC_COMPUTE}, {5}, 1}};
enum { SETS = sizeof sets / sizeof *sets };
static const unsigned all_stages = MATC_FRAGMENT | MATC_VERTEX | MATC_TESSVERTEX |
                                   MATC_TESSCONTROL | MATC_TESSEVAL | MATC_GEOMETRYVERTEX |
                                   MATC_GEOMETRY | MATC_COMPUTE | MATC_SPIRV | MATC_REFLECT;

static int judged;

/* Verdict of spirv-val; true if it is not installed. */
static bool passes(const char *words, size_t size)
{
    static int installed = -1;
    char path[] = "/tmp/matc-stage-XXXXXX", command[100];
    if (installed < 0)
        installed = !system("command -v spirv-val >/dev/null");
    const int file = installed ? mkstemp(path) : -1;
    if (file < 0)
        return !installed;
    const bool written = write(file, words, size) == (ssize_t)size;
    close(file);
    snprintf(command, sizeof command, "spirv-val --target-env vulkan1.0 %s", path);
    const bool fine = written && !system(command);
    remove(path);
    judged++;
    return fine;
}

static const SpirvVariable *at_location(const SpirvModule *m, SpirvStorage storage, int location)
{
    for (int i = 0; i < m->count; i++)
        if (m->variables[i].storage == storage && m->variables[i].location == location)
            return &m->variables[i];
    return NULL;
}

static const SpirvVariable *at_binding(const SpirvModule *m, int binding)
{
    for (int i = 0; i < m->count; i++)
        if (m->variables[i].binding == binding)
            return &m->variables[i];
    return NULL;
}

static void check_between(const char *what, const SpirvModule *before, const SpirvModule *after)
{
    for (int i = 0; i < after->count; i++) {
        const SpirvVariable *in = &after->variables[i], *out;
        if (in->storage != SPIRV_input)
            continue;
        out = at_location(before, SPIRV_output, in->location);
        if (!out || strcmp(in->type, out->type) != 0)
            fail_msg("%s: location %d is %s, and %s before", what, in->location, in->type,
                     out ? out->type : "nothing");
        if (in->array != (after->model >= 1 && after->model <= 3))
            fail_msg("%s: location %d is not one for each vertex", what, in->location);
    }
}

/* Each binding once, and what another stage has there is the same. */
static void check_bindings(const char *what, const SpirvModule *modules, int count)
{
    for (int i = 0; i < count; i++)
        for (int k = 0; k < modules[i].count; k++) {
            const SpirvVariable *own = &modules[i].variables[k];
            if (own->binding < 0)
                continue;
            if (own->set != 0 || at_binding(&modules[i], own->binding) != own)
                fail_msg("%s: binding %d of set %d", what, own->binding, own->set);
            for (int other = 0; other < i; other++) {
                const SpirvVariable *there = at_binding(&modules[other], own->binding);
                if (there &&
                    (there->storage != own->storage || strcmp(there->type, own->type) != 0))
                    fail_msg("%s: binding %d is %s, and %s in another stage", what, own->binding,
                             own->type, there->type);
            }
        }
}

static int binding_of(const cJSON *object)
{
    return cJSON_GetObjectItem(object, "binding")->valueint;
}

static bool in_any(const SpirvModule *modules, int count, int binding)
{
    for (int i = 0; i < count; i++)
        if (at_binding(&modules[i], binding))
            return true;
    return false;
}

/* Textures and the block of uniforms are where the reflection has them; so are a compute program's
 * buffers. */
static void check_reflection(const char *what, const cJSON *json, const SpirvModule *modules,
                             const MaterialSet *set)
{
    const cJSON *texture, *block = cJSON_GetObjectItem(json, "block"),
                          *compute = cJSON_GetObjectItem(json, "compute");
    const bool draws = set->output[0] == MATC_VERTEX;
    cJSON_ArrayForEach(
        texture, cJSON_GetObjectItem(json, "textures")) if (draws && !in_any(modules, set->count,
                                                                             binding_of(texture)))
        fail_msg("%s: no texture is bound to %d", what, binding_of(texture));
    if (draws && block && !in_any(modules, set->count, binding_of(block)))
        fail_msg("%s: no block is bound to %d", what, binding_of(block));
    if (set->output[0] != MATC_COMPUTE ||
        strcmp(cJSON_GetObjectItem(json, "target")->valuestring, "spirv") != 0)
        return; /* OpenGL counts storage buffers by themselves */
    static const char *const names[] = {"verticesBlock", "block", "read", "written"};
    for (int i = 0; i < 4; i++)
        assert_true(in_any(modules, 1, binding_of(cJSON_GetObjectItem(compute, names[i]))));
    assert_int_equal(modules[0].local_size, cJSON_GetObjectItem(compute, "localSize")->valueint);
}

static void check_set(const char *what, const MatcProgram *program, const MaterialSet *set,
                      const cJSON *json)
{
    static SpirvModule modules[MAX_STAGES];
    for (int i = 0; i < set->count; i++) {
        size_t size;
        const char *words = matc_spirv(program, set->output[i], &size);
        assert_non_null(words);
        if (!spirv_read(words, size, &modules[i]) || modules[i].model != set->model[i])
            fail_msg("%s: stage %d of a set is of model %d, not %d", what, i, modules[i].model,
                     set->model[i]);
        if (!passes(words, size))
            fail_msg("%s: spirv-val refuses stage %d of a set", what, i);
        if (i)
            check_between(what, &modules[i - 1], &modules[i]);
    }
    check_bindings(what, modules, set->count);
    check_reflection(what, json, modules, set);
}

static void check_document(const char *path, const MatcOptions *options)
{
    size_t size, words;
    char what[600];
    char *text = read_whole(path, &size);
    assert_non_null(text);
    MatcDocument *document = matc_read(path, text, size, options);
    for (int material = 0; material < matc_material_count(document); material++) {
        MatcProgram *program = matc_compile(document, material, all_stages, options);
        snprintf(what, sizeof what, "%s, material %d, target %s, pass %s", path, material,
                 options->target, options->pass);
        if (!matc_ok(program))
            fail_msg("%s: %s", what, matc_program_diagnostics(program, MATC_TEXT));
        assert_ptr_equal(matc_output(program, MATC_SPIRV, &size),
                         matc_spirv(program, MATC_FRAGMENT, &words));
        assert_int_equal(size, words);
        cJSON *json = cJSON_Parse(matc_output(program, MATC_REFLECT, NULL));
        for (int i = 0; i < SETS; i++)
            check_set(what, program, &sets[i], json);
        cJSON_Delete(json);
        matc_program_free(program);
    }
    matc_document_free(document);
    free(text);
}

static void stages_fit_together(void **state)
{
    (void)state;
    static const char *const documents[] = {"displacement.yaml",
                                            "checker.yaml",
                                            "bumpMap.yaml",
                                            "image.yaml",
                                            "channels/displacementVector.yaml",
                                            "channels/displacementPicture.yaml",
                                            "channels/displacementVolume.yaml"};
    static const char *const triangle_passes[] = {"gbuffer", "shadow", "depth"};
    for (size_t i = 0; i < 3 * sizeof documents / sizeof *documents; i++) {
        char path[300];
        MatcOptions options;
        matc_options_init(&options);
        /* from another target, by compiling once more */
        options.target = i % 2 ? "glsl450" : "spirv";
        options.pass = triangle_passes[i % 3];
        options.noise = i % 4 ? "lattice" : "groimp"; /* whose tables are textures */
        options.constants = i % 5 ? "baked" : "uniform";
        options.check = true;
        snprintf(path, sizeof path, "%s/examples/%s", SOURCE_FOLDER, documents[i / 3]);
        check_document(path, &options);
    }
    print_message("%d modules by spirv-val\n", judged);
}

/* Outputs that were not requested are absent, and so are those that have no words. */
static void words_are_those_asked_for(void **state)
{
    (void)state;
    static const char text[] = "material: Phong\n";
    MatcOptions options;
    matc_options_init(&options);
    options.target = "spirv";
    MatcDocument *document = matc_read("rock.yaml", text, strlen(text), &options);
    MatcProgram *program = matc_compile(document, 0, MATC_SPIRV | MATC_GEOMETRY, &options);
    assert_true(matc_ok(program) && matc_spirv(program, MATC_GEOMETRY, NULL) &&
                matc_spirv(program, MATC_GEOMETRYVERTEX, NULL) &&
                matc_spirv(program, MATC_FRAGMENT, NULL));
    assert_true(!matc_spirv(program, MATC_VERTEX, NULL) &&
                !matc_spirv(program, MATC_COMPUTE, NULL) &&
                !matc_spirv(program, MATC_REFLECT, NULL));
    matc_program_free(program);
    matc_document_free(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(stages_fit_together),
                                       cmocka_unit_test(words_are_those_asked_for)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
