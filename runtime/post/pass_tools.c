/* The tools pass: draws overlay lines in fixed colors that tone mapping does not change. The
 * lines are opaque in the depth buffer and black in the light target. Their colors are in a
 * separate target, attenuated by the same transparent surfaces, and are added by the tone pass.
 * The GLSL is tools_vertex.glsl and tools_fragment.glsl. */
#include "gen/render_text.h"
#include "runtime/frame/surface_draw.h"
#include "runtime/post/post.h"
#include "runtime/shadow/shadow_method.h"
#include "runtime/post/tool_lines.h"
#include <stddef.h>
#include <stdint.h>
#include <string.h>

static bool pass_tools_needed(const Render *render)
{
    const char *view = render->options.view;
    const SceneTools *tools = render->scene ? &render->scene->tools : NULL;
    if (render->scene && frame_look_has_shadows(render))
        return true;
    return tools && (tools->grid || tools->axes || tools->lights) && !render->options.linear &&
           (!view || !strcmp(view, "shown"));
}

bool pass_tools_are_there(const Render *render)
{
    return render->targets.plan.there >> FRAME_TARGET_tools & 1;
}

static void set(Render *render, const char *name, const float values[4])
{
    material_set(&render->picture->tools.material, &(MaterialValue){name, 4, values});
}

static void pass_tools_place(Render *render)
{
    if (render->picture->tools.material.store)
        set(render, "tools_ray", render->space.ray);
}

/* Sets the world's plane z = 0 in view space as dot(n, p) = c: n is the world's z axis, c the
 * origin's offset along n. */
static void set_ground(Render *render)
{
    const double *e = render->space.eye_from_world, *n = e + 8;
    const double along = n[0] * e[12] + n[1] * e[13] + n[2] * e[14] - render->scene->origin[2];
    set(render, "tools_ground", (float[]){(float)n[0], (float)n[1], (float)n[2], (float)along});
}

static bool make_vertices(Render *render)
{
    const GlContext *gl = render->gl;
    ToolLines lines;
    if (!tool_lines_make(render->scene, &render->space, &lines))
        return gl_fail(render->gl, "out of memory");
    render->picture->tools.count = lines.count;
    if (!render->picture->tools.array) {
        gl->GenVertexArrays(1, &render->picture->tools.array);
        gl->GenBuffers(1, &render->picture->tools.buffer);
    }
    gl->BindVertexArray(render->picture->tools.array);
    gl->BindBuffer(GL_ARRAY_BUFFER, render->picture->tools.buffer);
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
    return gl_check(render->gl, "making lines of tools");
}

static bool pass_tools_change(Render *render)
{
    const float *m = render->space.spaces.clip_from_eye.m;
    if (!render->picture->tools.material.store)
        return true;
    set(render, "tools_clip", (float[]){m[0], m[5], m[10], m[14]});
    set(render, "tools_w", (float[]){m[11], m[15], 0, 0});
    set(render, "tools_view", render->space.depth);
    set_ground(render);
    pass_tools_place(render);
    return make_vertices(render);
}

/* Makes two framebuffers: light and colors with depth for the lines, and colors only for
 * transparent surfaces in front. */
static bool make_targets(Render *render)
{
    const char *format = frame_format(render, FRAME_TARGET_tools, 0);
    const GLuint light = frame_texture(render, FRAME_TARGET_light, 0),
                 shown = frame_texture(render, FRAME_TARGET_tools, 0);
    const FramebufferSpec both = {render->size[0], render->size[1], 2, 0, true},
                          alone = {both.width, both.height, 1, 0, false};
    const FramebufferTextures lines = {.colors = {light, shown},
                                       .depth = frame_texture(render, FRAME_TARGET_depth, 0),
                                       .formats = {format, format}},
                              veil = {.colors = {shown}, .formats = {format}};
    return framebuffer_make_around(render->gl, &both, &lines, &render->picture->tools.lines) &&
           framebuffer_make_around(render->gl, &alone, &veil, &render->picture->tools.colors);
}

static bool pass_tools_make(Render *render)
{
    const bool modern = render->gl->major * 10 + render->gl->minor >= 45;
    const char *head = modern ? "#version 450 core\n" : "#version 330 core\n";
    const ProgramText text = {.vertex = {head, render_text_tools_vertex},
                              .fragment = {head, render_text_tools_fragment}};
    return make_targets(render) &&
           material_make(render->store, NULL, &text, &render->picture->tools.material) &&
           pass_tools_change(render) && shadow_methods_look_make(render);
}

static void pass_tools_draw(Render *render)
{
    static const float none[4];
    const GlContext *gl = render->gl;
    surface_draw_begin(render, &render->picture->tools.lines, GL_GREATER);
    gl->ClearBufferfv(GL_COLOR, 1, none);
    material_use(&render->picture->tools.material);
    gl->BindVertexArray(render->picture->tools.array);
    gl->DrawArrays(GL_LINES, 0, render->picture->tools.count);
    gl->BindVertexArray(0);
    shadow_methods_look_draw(render);
    surface_draw_end(render);
}

bool pass_tools_make_veil(Render *render, const LightingText *text)
{
    return !pass_tools_are_there(render) ||
           lighting_make(render, text, &render->picture->tools.veil);
}

void pass_tools_draw_veil(Render *render)
{
    if (pass_tools_are_there(render))
        screen_pass_run(&render->picture->tools.veil, &render->picture->tools.colors,
                        &render->screen);
}

static void pass_tools_delete(Render *render)
{
    const GlContext *gl = render->gl;
    material_delete(&render->picture->tools.material);
    screen_pass_delete(&render->picture->tools.veil);
    framebuffer_delete(gl, &render->picture->tools.lines);
    framebuffer_delete(gl, &render->picture->tools.colors);
    gl->DeleteVertexArrays(1, &render->picture->tools.array); /* GL ignores the name 0 */
    gl->DeleteBuffers(1, &render->picture->tools.buffer);
    render->picture->tools = (FrameTools){0};
}

static void pass_tools_place_all(Render *render)
{
    pass_tools_place(render);
    shadow_methods_look_place(render);
}

static bool pass_tools_changed(Render *render, unsigned what)
{
    shadow_methods_look_place(render);
    return !(what & (RENDER_CAMERA | RENDER_LIGHTS)) || pass_tools_change(render);
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
