/* The list of methods of indirect light, the choice among them, and the method's description for
 * --stats. */
#include "runtime/indirect/indirect_methods.h"
#include "runtime/frame_graph/transparency_draw.h"
#include "runtime/indirect/rays/pass_rays.h"

extern const IndirectMethod indirect_hybrid, indirect_voxels, indirect_screen, indirect_march,
    indirect_points;

/* `auto` selects the first possible method. */
static const IndirectMethod *const methods[] = {
    &indirect_hybrid, &indirect_voxels, &indirect_screen, &indirect_march, &indirect_points,
};
enum { METHODS = sizeof methods / sizeof *methods };

/* Looks at the scene alone, so that the GPU scene need not exist yet. */
static bool has_objects(const Scene *scene)
{
    int i = 0;
    while (i < scene->object_count &&
           (scene->objects[i].hidden || scene->objects[i].kind == SCENE_Plane))
        i++;
    return i < scene->object_count;
}

static bool is_possible(const Renderer *renderer, const IndirectMethod *method)
{
    return !(method->reads & INDIRECT_READS_voxels) ||
           (transparency_has_lists(renderer->gl) && has_objects(renderer->scene));
}

void indirect_methods_select(Renderer *renderer)
{
    const Keyword word = renderer->scene->indirect.method;
    const IndirectMethod *found = NULL;
    for (int i = 0; i < METHODS && !found; i++)
        if (word == KEYWORD_Indirect_auto
                ? methods[i]->automatic && is_possible(renderer, methods[i])
                : methods[i]->word == word)
            found = methods[i];
    renderer->indirect->method = found;
}

void indirect_methods_put(Text *out, const Renderer *renderer)
{
    const IndirectMethod *method = indirect_method(renderer);
    const int planes = indirect_planes_count(renderer),
              opaque = renderer->gpu_scene.opaque_plane_count;
    text_format(out, "indirect  by the method %s", keyword_table[method->word].name);
    if (renderer->scene->indirect.method == KEYWORD_Indirect_auto)
        text_format(out, ", as %s",
                    method->reads & INDIRECT_READS_voxels  ? "the scene has objects"
                    : transparency_has_lists(renderer->gl) ? "the scene has no objects for voxels"
                                                           : "voxels take OpenGL 4.3");
    text_put(out, "\n");
    if (indirect_is_directional(renderer))
        text_put(out, "indirect  light from all around comes by direction\n");
    if (planes)
        text_format(out, "indirect  rays hit %d of %d infinite planes, which are not voxelized\n",
                    planes, opaque);
}
