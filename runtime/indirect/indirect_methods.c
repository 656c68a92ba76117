/* The method of indirect light in words. */
#include "runtime/indirect/indirect_methods.h"
#include "grammar/tables.h"
#include "runtime/frame/transparency_draw.h"
#include "runtime/indirect/rays/pass_rays.h"

void indirect_methods_put(Text *out, const Render *render)
{
    const Word method = indirect_method(render);
    const int planes = indirect_planes_count(render), opaque = render->cache.opaque_plane_count;
    text_format(out, "indirect  by the method %s", word_table[method].name);
    if (render->scene->indirect.method == WORD_Indirect_auto)
        text_format(out, ", as %s",
                    method == WORD_Indirect_hybrid       ? "the scene has objects"
                    : transparency_has_lists(render->gl) ? "the scene has no objects for voxels"
                                                         : "voxels take OpenGL 4.3");
    text_put(out, "\n");
    if (indirect_is_directional(render))
        text_put(out, "indirect  light from all around comes by direction\n");
    if (planes)
        text_format(out, "indirect  rays meet %d of %d infinite planes, which are not in voxels\n",
                    planes, opaque);
}
