/* Opaque infinite planes, which rays of indirect light hit analytically. */
#include "runtime/frame_graph/frame.h"
#include "runtime/indirect/rays/pass_rays.h"
#include "runtime/shadow/shadow.h"
#include <stdio.h>

int indirect_planes_count(const Renderer *renderer)
{
    const int count = renderer->gpu_scene.opaque_plane_count;
    return !indirect_reads_radiance(renderer) ? 0
           : count < INDIRECT_PLANES_MAX      ? count
                                              : INDIRECT_PLANES_MAX;
}

void indirect_planes_define(const Renderer *renderer, char text[INDIRECT_PLANES_DEFINITION])
{
    *text = 0;
    if (indirect_planes_count(renderer))
        snprintf(text, INDIRECT_PLANES_DEFINITION, "#define INDIRECT_PLANES %d\n",
                 indirect_planes_count(renderer));
}

void indirect_planes_set(const Renderer *renderer, ScreenPass *pass)
{
    float planes[INDIRECT_PLANES_MAX][4];
    int count = 0;
    for (int i = 0; i < renderer->gpu_scene.plane_count && count < INDIRECT_PLANES_MAX; i++)
        if (!renderer->gpu_scene.planes[i].transparent)
            shadow_plane(
                renderer,
                &renderer->scene->objects[renderer->gpu_scene.planes[i].object].world_from_local,
                planes[count++]);
    material_write(&pass->material, "IndirectPlanes", planes, sizeof *planes * (size_t)count);
}
