/* The passes that rasterize: surfaces into depth and G-buffer, then infinite planes, then the
 * sky where depth is clear. Depth is reversed: cleared to 0, nearer is greater. */
#include "runtime/gpu_scene/gpu_scene_trace.h"
#include "runtime/frame_graph/surface_draw.h"
#include "runtime/renderer/passes.h"
#include "runtime/shadow/shadow_method.h"

static bool pass_surface_needed(const Renderer *renderer) { return renderer->scene != NULL; }
static bool pass_plane_needed(const Renderer *renderer)
{
    return renderer->gpu_scene.opaque_plane_count > 0 && surface_draw_is_shown(renderer);
}
static bool pass_sky_needed(const Renderer *renderer)
{
    return renderer->gpu_scene.has_sky && surface_draw_is_shown(renderer);
}

static void clear(const GlContext *gl, const Framebuffer *framebuffer)
{
    static const GLuint no_words[4];
    static const float no_floats[4];
    for (int i = 0; i < framebuffer->spec.color_count; i++)
        if (framebuffer_has_words(framebuffer, i))
            gl->ClearBufferuiv(GL_COLOR, i, no_words);
        else
            gl->ClearBufferfv(GL_COLOR, i, no_floats);
    gl->ClearBufferfv(GL_DEPTH, 0, no_floats);
}

/* Draws ray-marched surfaces in two steps: finds their hits and depth, then evaluates their
 * materials there. Nearer surfaces are drawn over them later. */
static void draw_traced(Renderer *renderer, const Framebuffer *framebuffer)
{
    static const GLuint nothing[4];
    GlContext *gl = renderer->gl;
    const GpuSceneSource source = frame_source(renderer);
    frame_use(renderer, &renderer->targets.draws[FRAME_DRAW_traced]);
    gl->ClearBufferuiv(GL_COLOR, 0, nothing);
    gpu_scene_trace_rays(gl, &source, &renderer->gpu_scene);
    frame_use(renderer, framebuffer);
    gl->Disable(GL_DEPTH_TEST);
    gpu_scene_trace_surfaces(gl, &source, &renderer->gpu_scene,
                             frame_texture(renderer, FRAME_TARGET_traced, 0));
    gl->Enable(GL_DEPTH_TEST);
}

/* Draws opaque surfaces. Triangle ids are drawn only once, and kept until something moves. */
static void pass_surface_draw(Renderer *renderer)
{
    const bool numbers = shadow_method_sees(renderer) && !renderer->shadows->seen;
    const Framebuffer *framebuffer =
        &renderer->targets.draws[numbers ? FRAME_DRAW_triangle_id : FRAME_DRAW_surface];
    surface_draw_begin(renderer, framebuffer, GL_GREATER);
    clear(renderer->gl, framebuffer);
    shadow_method_seen_bind(renderer);
    if (renderer->gpu_scene.tracing && surface_draw_is_shown(renderer))
        draw_traced(renderer, framebuffer);
    surface_draw_objects(renderer, false);
    surface_draw_end(renderer);
    renderer->shadows->seen |= numbers;
}

static void pass_plane_draw(Renderer *renderer)
{
    surface_draw_begin(renderer, &renderer->targets.draws[FRAME_DRAW_surface], GL_GREATER);
    surface_draw_planes(renderer, false);
    surface_draw_end(renderer);
}

/* The depth range makes every depth of the triangle 0, whatever its clip space position. */
static void pass_sky_draw(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    surface_draw_begin(renderer, &renderer->targets.draws[FRAME_DRAW_sky], GL_EQUAL);
    gl->DepthRange(0, 0);
    material_use(&renderer->gpu_scene.sky);
    screen_draw(gl, &renderer->screen);
    gl->DepthRange(0, 1);
    surface_draw_end(renderer);
}

/* The target `seen` (triangle ids) is filled only if a shadow technique reads it, `traced` only
 * for ray-marched displacement. */
static void pass_surface_request(const Renderer *renderer, FramePlanPass *row)
{
    row->fills &= ~(shadow_method_sees(renderer) ? 0 : FRAME_BIT(triangle_id)) &
                  ~(renderer->gpu_scene.tracing ? 0 : FRAME_BIT(traced));
}

const FramePass pass_surface = {
    .plan = {"surface", .fills = FRAME_BIT(depth) | FRAME_BIT(gbuffer) | FRAME_BIT(triangle_id) |
                                 FRAME_BIT(traced)},
    .when = "always: what is not drawn is clear",
    .needed = pass_surface_needed,
    .request = pass_surface_request,
    .draw = pass_surface_draw,
};

const FramePass pass_plane = {
    .plan = {"plane", .changes = FRAME_BIT(depth) | FRAME_BIT(gbuffer)},
    .when = "the scene has an infinite plane",
    .needed = pass_plane_needed,
    .draw = pass_plane_draw,
};

const FramePass pass_sky = {
    .plan = {"sky", .reads = FRAME_BIT(depth), .changes = FRAME_BIT(light)},
    .when = "the scene has a sky",
    .needed = pass_sky_needed,
    .draw = pass_sky_draw,
};
