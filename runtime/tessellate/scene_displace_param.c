/* Params of displacing materials: values that were set, instead of the documents' defaults. */
#include "runtime/tessellate/scene_displace.h"
#include "runtime/tessellate/scene_displace_param.h"
#include <stdlib.h>
#include <string.h>

Key scene_displacer_param_key(const SceneDisplacer *by, int material)
{
    Key key = {(uint64_t)material, 0};
    for (int i = 0; i < by->param_count; i++)
        if (by->params[i].material == material) {
            const Key parts[] = {
                key, key_of_bytes(by->params[i].name, strlen(by->params[i].name)),
                key_of_bytes(by->params[i].components, sizeof by->params[i].components)};
            key = key_of_bytes(parts, sizeof parts);
        }
    return key;
}

/* Exchanges a material's param values with its document's defaults; a second call restores them. */
void scene_displace_params(const Scene *scene, int material)
{
    for (int i = 0; i < scene->displacer->param_count; i++) {
        SceneDisplacedParam *param = &scene->displacer->params[i];
        double before[4];
        if (param->material != material)
            continue;
        matc_set_default(scene->materials[material].document, param->name, param->components,
                         param->count, before);
        memcpy(param->components, before, (size_t)param->count * sizeof *before);
    }
}

void scene_displace_free(Scene *scene)
{
    for (int i = 0; scene->displacer && i < scene->displacer->param_count; i++)
        free(scene->displacer->params[i].name);
    if (scene->displacer)
        free(scene->displacer->params);
}

bool scene_displacer_fail(SceneDisplacer *by, int material, const char *why)
{
    by->fault = material;
    by->why = why;
    return false;
}

bool scene_displacer_reads(const Scene *scene, int material, const char *name, int count)
{
    const SceneMaterial *of = &scene->materials[material];
    MatcOptions options = scene->displacer->options;
    bool reads = false;
    options.pass = "depth";
    options.moved = false;
    MatcProgram *program = matc_compile(of->document, of->index, MATC_KEY, &options);
    for (int i = 0; matc_ok(program) && i < matc_uniform_count(program); i++)
        reads |= !strcmp(matc_uniform(program, i)->param, name) &&
                 matc_uniform(program, i)->components == count;
    matc_program_free(program);
    return reads;
}

SceneDisplacedParam *scene_displacer_param(Scene *scene, int material, const char *name, int count)
{
    SceneDisplacer *by = scene->displacer;
    for (int i = 0; i < by->param_count; i++)
        if (by->params[i].material == material && !strcmp(by->params[i].name, name))
            return &by->params[i];
    SceneDisplacedParam *params =
        realloc(by->params, ((size_t)by->param_count + 1) * sizeof *params);
    char *copy = strdup(name);
    by->params = params ? params : by->params;
    if (!params || !copy) {
        free(copy);
        return NULL;
    }
    SceneDisplacedParam *param = &params[by->param_count++];
    *param = (SceneDisplacedParam){material, copy, {0}, count};
    const SceneMaterial *of = &scene->materials[material];
    /* stores the current default in param->components */
    matc_set_default(of->document, name, param->components, count, param->components);
    return param;
}
