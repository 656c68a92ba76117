/* Infinite planes that rays of indirect light meet; what these go through, in words. */
#include "grammar/tables.h"
#include "runtime/frame/frame.h"
#include "runtime/frame/transparency_draw.h"
#include "runtime/indirect/indirect.h"
#include "runtime/shadow/shadow.h"
#include <stdio.h>

int indirect_planes_count(const Render *render)
{
    const int count = render->cache.opaque_plane_count;
    return !indirect_reads_radiance(render) ? 0
           : count < INDIRECT_PLANES_MOST   ? count
                                            : INDIRECT_PLANES_MOST;
}

void indirect_planes_define(const Render *render, char text[INDIRECT_PLANES_DEFINITION])
{
    *text = 0;
    if (indirect_planes_count(render))
        snprintf(text, INDIRECT_PLANES_DEFINITION, "#define INDIRECT_PLANES %d\n",
                 indirect_planes_count(render));
}

void indirect_planes_set(const Render *render, ScreenPass *pass)
{
    float planes[INDIRECT_PLANES_MOST][4];
    int count = 0;
    for (int i = 0; i < render->cache.plane_count && count < INDIRECT_PLANES_MOST; i++)
        if (!render->cache.planes[i].transparent)
            shadow_plane(render,
                         &render->scene->objects[render->cache.planes[i].object].world_from_local,
                         planes[count++]);
    material_write(&pass->material, "IndirectPlanes", planes, sizeof *planes * (size_t)count);
}

void indirect_planes_put(Text *out, const Render *render)
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
