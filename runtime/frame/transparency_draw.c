/* Functions that the passes of transparent surfaces share. */
#include "runtime/frame/frame.h"
#include "runtime/frame/surface_draw.h"
#include "runtime/frame/transparency_draw.h"
#include <string.h>

/* Max bytes of a buffer of fragments, unless the driver's limit is lower. */
enum { LISTS_MOST = 1 << 30 };

static bool is_there(const GpuScene *gpu_scene)
{
    return gpu_scene->surface_count > gpu_scene->opaque_count ||
           gpu_scene->plane_count > gpu_scene->opaque_plane_count;
}

bool transparency_is(const Render *render, Transparency way)
{
    return is_there(&render->gpu_scene) && render->transparency == way &&
           surface_draw_is_shown(render);
}

void transparency_set(Render *render, const char *name, float number)
{
    for (int i = 0; i < render->gpu_scene.kind_count; i++)
        if (render->gpu_scene.kinds[i].transparent)
            material_set_number(&render->gpu_scene.kinds[i].material, name, number);
    for (int i = 0; i < render->gpu_scene.plane_count; i++)
        if (render->gpu_scene.planes[i].transparent)
            material_set_number(&render->gpu_scene.planes[i].material, name, number);
}

bool transparency_units(Render *render, int units[2])
{
    const GpuScene *gpu_scene = &render->gpu_scene;
    int most = 0;
    for (int i = 0; i < gpu_scene->kind_count; i++)
        if (gpu_scene->kinds[i].transparent && gpu_scene->kinds[i].material.texture_count > most)
            most = gpu_scene->kinds[i].material.texture_count;
    for (int i = 0; i < gpu_scene->plane_count; i++)
        if (gpu_scene->planes[i].transparent && gpu_scene->planes[i].material.texture_count > most)
            most = gpu_scene->planes[i].material.texture_count;
    for (int i = 0; i < 2; i++)
        units[i] = render->gl->max_texture_units - 2 + i;
    return most <= units[0] ||
           gl_fail(render->gl, "a transparent material has %d textures, and the driver room for %d",
                   most, units[0]);
}

bool transparency_has_lists(const GlContext *gl)
{
    return gl->major * 10 + gl->minor >= 43 && gl->BindBufferBase && gl->ClearBufferSubData &&
           gl->MemoryBarrier;
}

bool transparency_check(GlContext *gl, const RenderOptions *options)
{
    const char *way = options->transparency;
    if (way && strcmp(way, "auto") != 0 && strcmp(way, "lists") != 0 && strcmp(way, "peeling") != 0)
        return gl_fail(gl, "transparency is auto, lists or peeling, not '%s'", way);
    return !way || strcmp(way, "lists") != 0 || transparency_has_lists(gl) ||
           gl_fail(gl, "lists of fragments take OpenGL 4.3");
}

Transparency transparency_first(const Render *render)
{
    const char *way = render->options.transparency;
    return (way && !strcmp(way, "peeling")) || !transparency_has_lists(render->gl)
               ? TRANSPARENCY_peeling
               : TRANSPARENCY_lists;
}

size_t transparency_most_bytes(const Render *render)
{
    GLint most = 0;
    const size_t wanted = render->options.list_bytes ? render->options.list_bytes : LISTS_MOST;
    render->gl->GetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    return (size_t)most < wanted ? (size_t)most : wanted;
}
