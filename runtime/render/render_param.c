/* Parameters of materials: set in all programs, and stored, so that a rebuild can set them
 * again. */
#include "runtime/transparency/transparency_state.h"
#include "runtime/indirect/settings/indirect.h"
#include "runtime/indirect/radiance/radiance.h"
#include "runtime/indirect/voxels/voxels.h"
#include "runtime/render/passes.h"
#include "runtime/render/render.h"
#include "runtime/shadow/shadow.h"
#include <stdlib.h>
#include <string.h>

static bool set(Render *render, int material, const MaterialValue *value)
{
    const GpuSceneSource source = frame_source(render);
    const bool sheets = shadow_sheet_set(render, material, value);
    const bool nodes = radiance_param(render, material, value);
    indirect_forget(render);
    /* alpha-tested surfaces may have changed */
    indirect_doubt(render, INDIRECT_DOUBT_light | INDIRECT_DOUBT_openness);
    return gpu_scene_set(&source, &render->gpu_scene, material, value) || sheets || nodes;
}

static RenderParam *find(const Render *render, int material, const char *name)
{
    int i = 0;
    while (i < render->param_count &&
           (render->params[i].material != material || strcmp(render->params[i].name, name) != 0))
        i++;
    return i < render->param_count ? &render->params[i] : NULL;
}

static bool keep(Render *render, int material, const MaterialValue *value)
{
    RenderParam *param = find(render, material, value->name);
    if (!param) {
        RenderParam *params =
            realloc(render->params, ((size_t)render->param_count + 1) * sizeof *params);
        char *name = strdup(value->name);
        render->params = params ? params : render->params;
        if (!params || !name) {
            free(name);
            return gl_fail(render->gl, "out of memory");
        }
        param = &params[render->param_count++];
        *param = (RenderParam){.material = material, .name = name};
    }
    param->count = value->lanes;
    memcpy(param->lanes, value->values, (size_t)value->lanes * sizeof *param->lanes);
    return true;
}

bool render_param(Render *render, int material, const char *name, const float *lanes, int count)
{
    if (!render->scene)
        return gl_fail(render->gl, "there is no scene to change");
    render->uncounted = true; /* the number of alpha-tested fragments may have changed */
    render->shadows->drawn = false;
    pass_voxels_forget(render);
    const MaterialValue value = {name, count, lanes};
    if (!set(render, material, &value))
        return gl_fail(render->gl, "no program of the material has a param '%s' of %d lanes", name,
                       count);
    return keep(render, material, &value);
}

void render_param_again(Render *render)
{
    for (int i = 0; i < render->param_count; i++) {
        const RenderParam *param = &render->params[i];
        set(render, param->material, &(MaterialValue){param->name, param->count, param->lanes});
    }
}

void render_param_forget(Render *render)
{
    for (int i = 0; i < render->param_count; i++)
        free(render->params[i].name);
    free(render->params);
    render->params = NULL;
    render->param_count = 0;
}
