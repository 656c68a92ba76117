/* Functions that the passes of transparent surfaces share. */
#include "runtime/frame_graph/frame.h"
#include "runtime/frame_graph/surface_draw.h"
#include "runtime/frame_graph/transparency_draw.h"
#include <string.h>

/* Max bytes of a buffer of fragments, unless the driver's limit is lower. */
enum { LISTS_MAX = 1 << 30 };

static bool is_there(const GpuScene *gpu_scene)
{
    return gpu_scene->surface_count > gpu_scene->opaque_count ||
           gpu_scene->plane_count > gpu_scene->opaque_plane_count;
}

bool transparency_is(const Renderer *renderer, Transparency way)
{
    return is_there(&renderer->gpu_scene) && renderer->transparency == way &&
           surface_draw_is_shown(renderer);
}

void transparency_set(Renderer *renderer, const char *name, float number)
{
    for (int i = 0; i < renderer->gpu_scene.kind_count; i++)
        if (renderer->gpu_scene.kinds[i].transparent)
            material_set_number(&renderer->gpu_scene.kinds[i].material, name, number);
    for (int i = 0; i < renderer->gpu_scene.plane_count; i++)
        if (renderer->gpu_scene.planes[i].transparent)
            material_set_number(&renderer->gpu_scene.planes[i].material, name, number);
}

bool transparency_units(Renderer *renderer, int units[2])
{
    const GpuScene *gpu_scene = &renderer->gpu_scene;
    int most = 0;
    for (int i = 0; i < gpu_scene->kind_count; i++)
        if (gpu_scene->kinds[i].transparent && gpu_scene->kinds[i].material.texture_count > most)
            most = gpu_scene->kinds[i].material.texture_count;
    for (int i = 0; i < gpu_scene->plane_count; i++)
        if (gpu_scene->planes[i].transparent && gpu_scene->planes[i].material.texture_count > most)
            most = gpu_scene->planes[i].material.texture_count;
    for (int i = 0; i < 2; i++)
        units[i] = renderer->gl->max_texture_units - 2 + i;
    return most <= units[0] ||
           gl_fail(renderer->gl,
                   "a transparent material has %d textures, and the driver room for %d", most,
                   units[0]);
}

bool transparency_has_lists(const GlContext *gl)
{
    return gl->major * 10 + gl->minor >= 43 && gl->BindBufferBase && gl->ClearBufferSubData &&
           gl->MemoryBarrier;
}

bool transparency_check(GlContext *gl, const RendererOptions *options)
{
    const char *way = options->transparency;
    if (way && strcmp(way, "auto") != 0 && strcmp(way, "lists") != 0 && strcmp(way, "peeling") != 0)
        return gl_fail(gl, "transparency is auto, lists or peeling, not '%s'", way);
    return !way || strcmp(way, "lists") != 0 || transparency_has_lists(gl) ||
           gl_fail(gl, "lists of fragments take OpenGL 4.3");
}

Transparency transparency_first(const Renderer *renderer)
{
    const char *way = renderer->options.transparency;
    return (way && !strcmp(way, "peeling")) || !transparency_has_lists(renderer->gl)
               ? TRANSPARENCY_peeling
               : TRANSPARENCY_lists;
}

size_t transparency_most_bytes(const Renderer *renderer)
{
    GLint most = 0;
    const size_t wanted = renderer->options.list_bytes ? renderer->options.list_bytes : LISTS_MAX;
    renderer->gl->GetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    return (size_t)most < wanted ? (size_t)most : wanted;
}
