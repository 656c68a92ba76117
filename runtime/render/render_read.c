/* Reads a frame. The picture is already averaged over the samples of each pixel; other views are
 * averaged here. */
#include "runtime/indirect/screen/pass_positions.h"
#include "runtime/indirect/settings/indirect.h"
#include "runtime/indirect/voxels/voxels.h"
#include "runtime/render/passes.h"
#include "runtime/render/render.h"
#include "runtime/shadow/shadow_state.h"
#include <stdlib.h>
#include <string.h>

static const char *view_of(const Render *render)
{
    return render->options.view ? render->options.view : "shown";
}

/* Reads coverage into the last component, and, with `shown`, depth into the first. */
static bool read_depth(Render *render, bool shown, float *rgba)
{
    GlContext *gl = render->gl;
    const size_t count = (size_t)render->size[0] * (size_t)render->size[1];
    float *depth = malloc(count * sizeof *depth);
    if (!depth)
        return gl_fail(gl, "out of memory");
    gl->BindFramebuffer(GL_FRAMEBUFFER, render->targets.draws[FRAME_DRAW_surface].name);
    gl->ReadPixels(0, 0, render->size[0], render->size[1], GL_DEPTH_COMPONENT, GL_FLOAT, depth);
    for (size_t i = 0; i < count; i++) {
        if (shown)
            memcpy(rgba + 4 * i, (float[4]){depth[i]}, 4 * sizeof *rgba);
        rgba[4 * i + 3] = depth[i] > 0;
    }
    free(depth);
    return gl_check(gl, "reading the depth");
}

/* Moves the last component to the first. */
static bool show_last(const Render *render, float *rgba)
{
    for (size_t i = 0; i < (size_t)render->size[0] * (size_t)render->size[1]; i++)
        rgba[4 * i] = rgba[4 * i + 3];
    return true;
}

static bool read_samples(Render *render, float *rgba)
{
    const char *view = view_of(render);
    const Framebuffer *surface = &render->targets.draws[FRAME_DRAW_surface];
    if (!strcmp(view, "light"))
        return framebuffer_read(render->gl, &render->targets.draws[FRAME_DRAW_light], 0, rgba);
    if (!strcmp(view, "depth"))
        return read_depth(render, true, rgba);
    if (indirect_view_lanes(view))
        return framebuffer_read(render->gl, &render->targets.draws[FRAME_DRAW_open], 0, rgba) &&
               (indirect_view_lanes(view) > 1 || show_last(render, rgba));
    if (voxels_view_level(view) >= 0)
        return framebuffer_read(render->gl, &render->targets.draws[FRAME_DRAW_cubes], 0, rgba);
    if (pass_positions_is_view(view))
        return framebuffer_read(render->gl, &render->targets.draws[FRAME_DRAW_positions], 0, rgba);
    if (render->has_reader)
        return reader_read(&render->reader, surface, render_find_slot(view), rgba) &&
               read_depth(render, false, rgba);
    memset(rgba, 0, 4 * sizeof *rgba * (size_t)render->size[0] * (size_t)render->size[1]);
    return true; /* a scene without surfaces */
}

bool render_lacks_view(const Render *render)
{
    return render->has_reader && !render->reader.holds[render_find_slot(view_of(render))];
}

/* Averages the samples of a pixel; for a slot only those that show a surface. */
static void mean(const float *samples, int stride, int n, bool slot, float out[4])
{
    double sum[4] = {0};
    for (int row = 0; row < n; row++)
        for (int column = 0; column < n; column++) {
            const float *sample = samples + 4 * (row * stride + column);
            for (int lane = 0; lane < 4; lane++)
                sum[lane] += slot && lane < 3 ? sample[3] * sample[lane] : sample[lane];
        }
    for (int lane = 0; lane < 4; lane++)
        out[lane] =
            (float)(slot && lane < 3 ? sum[lane] / (sum[3] > 0 ? sum[3] : 1) : sum[lane] / (n * n));
}

static void reduce(const Render *render, const float *samples, float *rgba)
{
    const int n = render->samples, stride = render->size[0], margin = render->margin;
    const int width = render_tile_width(render), height = render_tile_height(render);
    samples += 4 * ((size_t)margin * (size_t)stride + (size_t)margin);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            mean(samples + 4 * ((size_t)y * (size_t)stride + (size_t)x) * (size_t)n, stride, n,
                 render->has_reader, rgba + 4 * ((size_t)y * (size_t)width + (size_t)x));
}

static bool read_mean(Render *render, float *rgba)
{
    float *samples =
        malloc((size_t)render->size[0] * (size_t)render->size[1] * 4 * sizeof *samples);
    if (!samples)
        return gl_fail(render->gl, "out of memory");
    const bool done = read_samples(render, samples);
    if (done)
        reduce(render, samples, rgba);
    free(samples);
    return done;
}

bool render_read(Render *render, float *rgba)
{
    const int margin = render->margin / render->samples;
    const FramebufferPart part = {0, margin, margin, render_tile_width(render),
                                  render_tile_height(render)};
    if (!render->scene)
        return gl_fail(render->gl, "there is no scene to read");
    if (!gl_check(render->gl, "drawing a frame"))
        return false;
    if (!strcmp(view_of(render), "shown"))
        return framebuffer_read_part(render->gl, &render->targets.draws[FRAME_DRAW_shown], &part,
                                     rgba);
    return render->samples > 1 || render->margin ? read_mean(render, rgba)
                                                 : read_samples(render, rgba);
}

int render_map_count(const Render *render)
{
    return render->shadows->maps ? render->shadows->views.count : 0;
}
int render_map_size(const Render *render) { return render->scene->shadow_size; }

bool render_read_map(Render *render, int map, float *depths)
{
    GlContext *gl = render->gl;
    const int size = render_map_size(render);
    gl->BindFramebuffer(GL_FRAMEBUFFER, render->shadows->framebuffer);
    gl->FramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, render->shadows->maps, 0, map);
    gl->ReadPixels(0, 0, size, size, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
    return gl_check(gl, "reading a shadow map");
}
