#include "runtime/indirect/voxels/voxels.h"
#include "runtime/renderer/displaced_stats.h"
#include "runtime/displace/traced/displaced_traced.h"
#include "runtime/tessellate/scene_displacement.h"
#include "runtime/shadow/shadow_method.h"
#include <stdio.h>

/* Lists the passes that use triangles although the surface is ray-marched in the picture, such
 * as "voxels, edges". */
static void put_grids(Text *out, const Renderer *renderer)
{
    const ShadowViews *views = &renderer->shadows->views;
    enum { NAME_CHARS = 64 };
    char meshes[NAME_CHARS] = "";
    bool traced_maps = false, transparent = false;
    for (int i = 0; renderer->targets.plan.there >> FRAME_TARGET_shadow & 1 && i < views->count;
         i++) {
        const ShadowMethod *method = views->views[i].method;
        if (method->meshes)
            snprintf(meshes, sizeof meshes, "%s shadows", keyword_table[method->word].name);
        traced_maps |= !method->meshes;
    }
    for (int i = 0; i < renderer->gpu_scene.place_count; i++)
        transparent |=
            renderer->gpu_scene.places[i].transparent &&
            displaced_traced(&renderer->gpu_scene.displaced[renderer->gpu_scene.places[i].mesh]);
    const struct {
        bool there;
        const char *name;
    } grids[] = {{renderer->voxels->map != 0, "voxels"},
                 {renderer->targets.plan.there >> FRAME_TARGET_edge & 1, "edges"},
                 {*meshes, meshes},
                 {traced_maps && renderer->scene->displaced_by == KEYWORD_Displacing_parallax,
                  "shadow maps"},
                 {transparent, "what is transparent"}};
    const char *comma = "; not so, but its grid's triangles: ";
    for (size_t i = 0; i < sizeof grids / sizeof *grids; i++)
        if (grids[i].there) {
            text_format(out, "%s%s", comma, grids[i].name);
            comma = ", ";
        }
}

/* Describes the ray-marched surfaces, or the reason why triangles are drawn instead. */
static void put_traced(Text *out, const Renderer *renderer)
{
    const GpuScene *gpu_scene = &renderer->gpu_scene;
    const GpuSceneSource source = frame_source(renderer);
    int meshes = 0;
    if (!renderer->scene->displaced || !scene_displaced_traced(renderer->scene->displaced_by))
        return;
    for (int i = 0; i < gpu_scene->mesh_count; i++)
        meshes += displaced_traced(&gpu_scene->displaced[i]) != NULL;
    text_put(out, "traced    ");
    if (gpu_scene->tracing) {
        text_format(out, "the surface of %d mesh%s", meshes, meshes == 1 ? "" : "es");
        put_grids(out, renderer);
    } else
        text_format(out, "none, triangles are drawn: %s",
                    !meshes          ? "it takes OpenGL 4.5, a height with a bound, and no volume"
                    : source.lines   ? "lines are those of triangles"
                    : source.written ? "a shadow technique reads triangle ids"
                                     : "what is transparent is not traced");
    text_char(out, '\n');
}

/* Describes the cell sizes of volumes, once for consecutive objects that share a mesh. */
static void put_volumes(Text *out, const Renderer *renderer)
{
    enum { DIGITS = 2 };
    const Scene *scene = renderer->scene;
    int last = -1;
    for (int i = 0; i < scene->object_count; i++) {
        const SceneObject *object = &scene->objects[i];
        const double *steps = object->kind == SCENE_Mesh ? scene->meshes[object->mesh].steps : NULL;
        const SceneMaterial *of = &scene->materials[object->material];
        if (!steps || steps[0] <= 0 || object->mesh == last)
            continue;
        last = object->mesh;
        text_format(out, "volume    %s: what is thinner than ",
                    matc_material_name(of->document, of->index));
        text_rounded(out, steps[0], DIGITS);
        text_put(out, " across, or ");
        text_rounded(out, steps[1], DIGITS);
        text_put(out, " along the normal, may be missed\n");
    }
}

void displaced_stats_put(Text *out, const Renderer *renderer)
{
    put_traced(out, renderer);
    put_volumes(out, renderer);
}
