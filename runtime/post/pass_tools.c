/* The tools pass: draws overlay lines in fixed colors that tone mapping does not change. The
 * lines are opaque in the depth buffer and black in the light target. Their colors are in a
 * separate target, attenuated by the same transparent surfaces, and are added by the tone pass.
 * The GLSL is tools_vertex.glsl and tools_fragment.glsl. */
#include "gen/render_text.h"
#include "runtime/frame_graph/surface_draw.h"
#include "runtime/post/post.h"
#include "runtime/shadow/shadow_method.h"
#include "runtime/post/tool_lines.h"
#include <stddef.h>
#include <stdint.h>
#include <string.h>

static bool pass_tools_needed(const Renderer *renderer)
{
    const char *view = renderer->options.view;
    const SceneTools *tools = renderer->scene ? &renderer->scene->tools : NULL;
    if (renderer->scene && frame_look_has_shadows(renderer))
        return true;
    return tools && (tools->grid || tools->axes || tools->lights) && !renderer->options.linear &&
           (!view || !strcmp(view, "final"));
}

bool pass_tools_enabled(const Renderer *renderer)
{
    return renderer->targets.plan.there >> FRAME_TARGET_tools & 1;
}

static void set(Renderer *renderer, const char *name, const float values[4])
{
    material_set(&renderer->post->tools.material, &(MaterialValue){name, 4, values});
}

static void pass_tools_place(Renderer *renderer)
{
    if (renderer->post->tools.material.store)
        set(renderer, "tools_ray", renderer->space.ray);
}

/* Sets the world's plane z = 0 in view space as dot(n, p) = c: n is the world's z axis, c the
 * origin's offset along n. */
static void set_ground(Renderer *renderer)
{
    const double *e = renderer->space.eye_from_world, *n = e + 8;
    const double along = n[0] * e[12] + n[1] * e[13] + n[2] * e[14] - renderer->scene->origin[2];
    set(renderer, "tools_ground", (float[]){(float)n[0], (float)n[1], (float)n[2], (float)along});
}

static bool make_vertices(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    ToolLines lines;
    if (!tool_lines_make(renderer->scene, &renderer->space, &lines))
        return gl_fail(renderer->gl, "out of memory");
    renderer->post->tools.count = lines.count;
    if (!renderer->post->tools.array) {
        gl->GenVertexArrays(1, &renderer->post->tools.array);
        gl->GenBuffers(1, &renderer->post->tools.buffer);
    }
    gl->BindVertexArray(renderer->post->tools.array);
    gl->BindBuffer(GL_ARRAY_BUFFER, renderer->post->tools.buffer);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)lines.count * (GLsizeiptr)sizeof *lines.vertices,
                   lines.vertices, GL_DYNAMIC_DRAW);
    for (GLuint i = 0; i < 2; i++) {
        gl->EnableVertexAttribArray(i);
        /* GL takes offsets as pointers */
        gl->VertexAttribPointer(i, i ? 3 : 4, GL_FLOAT, GL_FALSE, sizeof(ToolVertex),
                                (const void *)(uintptr_t)(i ? offsetof(ToolVertex, color) : 0));
    }
    gl->BindVertexArray(0);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    tool_lines_free(&lines);
    return gl_check(renderer->gl, "making lines of tools");
}

static bool pass_tools_change(Renderer *renderer)
{
    const float *m = renderer->space.spaces.clip_from_eye.m;
    if (!renderer->post->tools.material.store)
        return true;
    set(renderer, "tools_clip", (float[]){m[0], m[5], m[10], m[14]});
    set(renderer, "tools_w", (float[]){m[11], m[15], 0, 0});
    set(renderer, "tools_view", renderer->space.depth);
    set_ground(renderer);
    pass_tools_place(renderer);
    return make_vertices(renderer);
}

/* Makes two framebuffers: light and colors with depth for the lines, and colors only for
 * transparent surfaces in front. */
static bool make_targets(Renderer *renderer)
{
    const char *format = frame_format(renderer, FRAME_TARGET_tools, 0);
    const GLuint light = frame_texture(renderer, FRAME_TARGET_light, 0),
                 shown = frame_texture(renderer, FRAME_TARGET_tools, 0);
    const FramebufferSpec both = {renderer->size[0], renderer->size[1], 2, 0, true},
                          alone = {both.width, both.height, 1, 0, false};
    const FramebufferTextures lines = {.colors = {light, shown},
                                       .depth = frame_texture(renderer, FRAME_TARGET_depth, 0),
                                       .formats = {format, format}},
                              veil = {.colors = {shown}, .formats = {format}};
    return framebuffer_make_around(renderer->gl, &both, &lines, &renderer->post->tools.lines) &&
           framebuffer_make_around(renderer->gl, &alone, &veil, &renderer->post->tools.colors);
}

static bool pass_tools_make(Renderer *renderer)
{
    const bool modern = renderer->gl->major * 10 + renderer->gl->minor >= 45;
    const char *head = modern ? "#version 450 core\n" : "#version 330 core\n";
    const ProgramText text = {.vertex = {head, render_text_tools_vertex},
                              .fragment = {head, render_text_tools_fragment}};
    return make_targets(renderer) &&
           material_make(renderer->store, NULL, &text, &renderer->post->tools.material) &&
           pass_tools_change(renderer) && shadow_methods_look_make(renderer);
}

static void pass_tools_draw(Renderer *renderer)
{
    static const float none[4];
    const GlContext *gl = renderer->gl;
    surface_draw_begin(renderer, &renderer->post->tools.lines, GL_GREATER);
    gl->ClearBufferfv(GL_COLOR, 1, none);
    material_use(&renderer->post->tools.material);
    gl->BindVertexArray(renderer->post->tools.array);
    gl->DrawArrays(GL_LINES, 0, renderer->post->tools.count);
    gl->BindVertexArray(0);
    shadow_methods_look_draw(renderer);
    surface_draw_end(renderer);
}

bool pass_tools_make_veil(Renderer *renderer, const LightingText *text)
{
    return !pass_tools_enabled(renderer) ||
           lighting_make(renderer, text, &renderer->post->tools.veil);
}

void pass_tools_draw_veil(Renderer *renderer)
{
    if (pass_tools_enabled(renderer))
        screen_pass_run(&renderer->post->tools.veil, &renderer->post->tools.colors,
                        &renderer->screen);
}

static void pass_tools_delete(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    material_delete(&renderer->post->tools.material);
    screen_pass_delete(&renderer->post->tools.veil);
    framebuffer_delete(gl, &renderer->post->tools.lines);
    framebuffer_delete(gl, &renderer->post->tools.colors);
    gl->DeleteVertexArrays(1, &renderer->post->tools.array); /* GL ignores the name 0 */
    gl->DeleteBuffers(1, &renderer->post->tools.buffer);
    renderer->post->tools = (FrameTools){0};
}

static void pass_tools_place_all(Renderer *renderer)
{
    pass_tools_place(renderer);
    shadow_methods_look_place(renderer);
}

static bool pass_tools_changed(Renderer *renderer, unsigned what)
{
    shadow_methods_look_place(renderer);
    return !(what & (RENDERER_CAMERA | RENDERER_LIGHTS)) || pass_tools_change(renderer);
}

const FramePass pass_tools = {
    .plan = {"tools", .reads = FRAME_BIT(shadow), .fills = FRAME_BIT(tools),
             .changes = FRAME_BIT(depth) | FRAME_BIT(light)},
    .when = "tools are asked for, or a view of shadow volumes",
    .needed = pass_tools_needed,
    .make = pass_tools_make,
    .draw = pass_tools_draw,
    .place = pass_tools_place_all,
    .changed = pass_tools_changed,
    .forget = pass_tools_delete,
};
