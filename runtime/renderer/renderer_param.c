/* Parameters of materials: set in all programs, and stored, so that a rebuild can set them
 * again. */
#include "runtime/transparency/transparency_state.h"
#include "runtime/indirect/settings/indirect.h"
#include "runtime/indirect/radiance/radiance.h"
#include "runtime/indirect/voxels/voxels.h"
#include "runtime/renderer/passes.h"
#include "runtime/renderer/renderer.h"
#include "runtime/shadow/shadow.h"
#include <stdlib.h>
#include <string.h>

static bool set(Renderer *renderer, int material, const MaterialValue *value)
{
    const GpuSceneSource source = frame_source(renderer);
    const bool sheets = plane_transmittance_set(renderer, material, value);
    const bool nodes = radiance_param(renderer, material, value);
    indirect_forget(renderer);
    /* alpha-tested surfaces may have changed */
    indirect_invalidate(renderer, INDIRECT_DIRTY_light | INDIRECT_DIRTY_ao);
    return gpu_scene_set(&source, &renderer->gpu_scene, material, value) || sheets || nodes;
}

static RendererParam *find(const Renderer *renderer, int material, const char *name)
{
    int i = 0;
    while (i < renderer->param_count && (renderer->params[i].material != material ||
                                         strcmp(renderer->params[i].name, name) != 0))
        i++;
    return i < renderer->param_count ? &renderer->params[i] : NULL;
}

static bool keep(Renderer *renderer, int material, const MaterialValue *value)
{
    RendererParam *param = find(renderer, material, value->name);
    if (!param) {
        RendererParam *params =
            realloc(renderer->params, ((size_t)renderer->param_count + 1) * sizeof *params);
        char *name = strdup(value->name);
        renderer->params = params ? params : renderer->params;
        if (!params || !name) {
            free(name);
            return gl_fail(renderer->gl, "out of memory");
        }
        param = &params[renderer->param_count++];
        *param = (RendererParam){.material = material, .name = name};
    }
    param->count = value->components;
    memcpy(param->components, value->values, (size_t)value->components * sizeof *param->components);
    return true;
}

bool renderer_param(Renderer *renderer, int material, const char *name, const float *components,
                    int count)
{
    if (!renderer->scene)
        return gl_fail(renderer->gl, "no scene to change");
    renderer->uncounted = true; /* the number of alpha-tested fragments may have changed */
    renderer->shadows->drawn = false;
    pass_voxels_forget(renderer);
    const MaterialValue value = {name, count, components};
    if (!set(renderer, material, &value))
        return gl_fail(renderer->gl, "no program of the material has a param '%s' of %d components",
                       name, count);
    return keep(renderer, material, &value);
}

void renderer_param_rebuild(Renderer *renderer)
{
    for (int i = 0; i < renderer->param_count; i++) {
        const RendererParam *param = &renderer->params[i];
        set(renderer, param->material,
            &(MaterialValue){param->name, param->count, param->components});
    }
}

void renderer_param_forget(Renderer *renderer)
{
    for (int i = 0; i < renderer->param_count; i++)
        free(renderer->params[i].name);
    free(renderer->params);
    renderer->params = NULL;
    renderer->param_count = 0;
}
