/* Opaque infinite planes, which rays of indirect light hit analytically. */
#include "runtime/frame/frame.h"
#include "runtime/indirect/rays/pass_rays.h"
#include "runtime/shadow/shadow.h"
#include <stdio.h>

int indirect_planes_count(const Render *render)
{
    const int count = render->gpu_scene.opaque_plane_count;
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
    for (int i = 0; i < render->gpu_scene.plane_count && count < INDIRECT_PLANES_MOST; i++)
        if (!render->gpu_scene.planes[i].transparent)
            shadow_plane(
                render,
                &render->scene->objects[render->gpu_scene.planes[i].object].world_from_local,
                planes[count++]);
    material_write(&pass->material, "IndirectPlanes", planes, sizeof *planes * (size_t)count);
}
