/* Reads a frame. The picture is already averaged over the samples of each pixel; other views are
 * averaged here. */
#include "runtime/indirect/screen/pass_positions.h"
#include "runtime/indirect/settings/indirect.h"
#include "runtime/indirect/voxels/voxels.h"
#include "runtime/renderer/passes.h"
#include "runtime/renderer/renderer.h"
#include "runtime/shadow/shadow_state.h"
#include <stdlib.h>
#include <string.h>

static const char *view_of(const Renderer *renderer)
{
    return renderer->options.view ? renderer->options.view : "final";
}

/* Reads coverage into the last component, and, with `final`, depth into the first. */
static bool read_depth(Renderer *renderer, bool shown, float *rgba)
{
    GlContext *gl = renderer->gl;
    const size_t count = (size_t)renderer->size[0] * (size_t)renderer->size[1];
    float *depth = malloc(count * sizeof *depth);
    if (!depth)
        return gl_fail(gl, "out of memory");
    gl->BindFramebuffer(GL_FRAMEBUFFER, renderer->targets.draws[FRAME_DRAW_surface].name);
    gl->ReadPixels(0, 0, renderer->size[0], renderer->size[1], GL_DEPTH_COMPONENT, GL_FLOAT, depth);
    for (size_t i = 0; i < count; i++) {
        if (shown)
            memcpy(rgba + 4 * i, (float[4]){depth[i]}, 4 * sizeof *rgba);
        rgba[4 * i + 3] = depth[i] > 0;
    }
    free(depth);
    return gl_check(gl, "reading the depth");
}

/* Moves the last component to the first. */
static bool show_last(const Renderer *renderer, float *rgba)
{
    for (size_t i = 0; i < (size_t)renderer->size[0] * (size_t)renderer->size[1]; i++)
        rgba[4 * i] = rgba[4 * i + 3];
    return true;
}

static bool read_samples(Renderer *renderer, float *rgba)
{
    const char *view = view_of(renderer);
    const Framebuffer *surface = &renderer->targets.draws[FRAME_DRAW_surface];
    if (!strcmp(view, "light"))
        return framebuffer_read(renderer->gl, &renderer->targets.draws[FRAME_DRAW_light], 0, rgba);
    if (!strcmp(view, "depth"))
        return read_depth(renderer, true, rgba);
    if (indirect_view_components(view))
        return framebuffer_read(renderer->gl, &renderer->targets.draws[FRAME_DRAW_ao], 0, rgba) &&
               (indirect_view_components(view) > 1 || show_last(renderer, rgba));
    if (voxels_view_level(view) >= 0)
        return framebuffer_read(renderer->gl, &renderer->targets.draws[FRAME_DRAW_cubes], 0, rgba);
    if (pass_positions_is_view(view))
        return framebuffer_read(renderer->gl, &renderer->targets.draws[FRAME_DRAW_positions], 0,
                                rgba);
    if (renderer->has_reader)
        return reader_read(&renderer->reader, surface, renderer_find_slot(view), rgba) &&
               read_depth(renderer, false, rgba);
    memset(rgba, 0, 4 * sizeof *rgba * (size_t)renderer->size[0] * (size_t)renderer->size[1]);
    return true; /* the scene has no surfaces */
}

bool renderer_missing_view(const Renderer *renderer)
{
    return renderer->has_reader && !renderer->reader.holds[renderer_find_slot(view_of(renderer))];
}

/* Averages the samples of a pixel; for a slot only those that show a surface. */
static void mean(const float *samples, int stride, int n, bool slot, float out[4])
{
    double sum[4] = {0};
    for (int row = 0; row < n; row++)
        for (int column = 0; column < n; column++) {
            const float *sample = samples + 4 * (row * stride + column);
            for (int component = 0; component < 4; component++)
                sum[component] +=
                    slot && component < 3 ? sample[3] * sample[component] : sample[component];
        }
    for (int component = 0; component < 4; component++)
        out[component] = (float)(slot && component < 3 ? sum[component] / (sum[3] > 0 ? sum[3] : 1)
                                                       : sum[component] / (n * n));
}

static void reduce(const Renderer *renderer, const float *samples, float *rgba)
{
    const int n = renderer->samples, stride = renderer->size[0], margin = renderer->margin;
    const int width = renderer_tile_width(renderer), height = renderer_tile_height(renderer);
    samples += 4 * ((size_t)margin * (size_t)stride + (size_t)margin);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            mean(samples + 4 * ((size_t)y * (size_t)stride + (size_t)x) * (size_t)n, stride, n,
                 renderer->has_reader, rgba + 4 * ((size_t)y * (size_t)width + (size_t)x));
}

static bool read_mean(Renderer *renderer, float *rgba)
{
    float *samples =
        malloc((size_t)renderer->size[0] * (size_t)renderer->size[1] * 4 * sizeof *samples);
    if (!samples)
        return gl_fail(renderer->gl, "out of memory");
    const bool done = read_samples(renderer, samples);
    if (done)
        reduce(renderer, samples, rgba);
    free(samples);
    return done;
}

bool renderer_read(Renderer *renderer, float *rgba)
{
    const int margin = renderer->margin / renderer->samples;
    const FramebufferPart part = {0, margin, margin, renderer_tile_width(renderer),
                                  renderer_tile_height(renderer)};
    if (!renderer->scene)
        return gl_fail(renderer->gl, "no scene to read");
    if (!gl_check(renderer->gl, "drawing a frame"))
        return false;
    if (!strcmp(view_of(renderer), "final"))
        return framebuffer_read_part(renderer->gl, &renderer->targets.draws[FRAME_DRAW_final],
                                     &part, rgba);
    return renderer->samples > 1 || renderer->margin ? read_mean(renderer, rgba)
                                                     : read_samples(renderer, rgba);
}

int renderer_map_count(const Renderer *renderer)
{
    return renderer->shadows->maps ? renderer->shadows->views.count : 0;
}
int renderer_map_size(const Renderer *renderer) { return renderer->scene->shadow_size; }

bool renderer_read_map(Renderer *renderer, int map, float *depths)
{
    GlContext *gl = renderer->gl;
    const int size = renderer_map_size(renderer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, renderer->shadows->framebuffer);
    gl->FramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, renderer->shadows->maps, 0,
                                map);
    gl->ReadPixels(0, 0, size, size, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
    return gl_check(gl, "reading a shadow map");
}
