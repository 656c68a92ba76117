/* The passes lists and blend: store transparent fragments in per-pixel linked lists, and
 * composite these over the light. Their GLSL is lists_store.glsl, which follows the materials'
 * own, and pass_blend.glsl. */
#include "gen/lists_layout.h"
#include "gen/render_text.h"
#include "runtime/frame/surface_draw.h"
#include "runtime/frame/transparency_draw.h"
#include "runtime/transparency/transparency_passes.h"
#include "runtime/post/post.h"
#include <stdio.h>
#include <string.h>

static bool pass_lists_needed(const Render *render)
{
    return transparency_is(render, TRANSPARENCY_lists);
}

static size_t bytes_of(const Render *render, GLuint fragments)
{
    const size_t pixels = (size_t)render->size[0] * (size_t)render->size[1];
    return sizeof(GLuint) *
           (LISTS_HEADS + pixels + (size_t)fragments * (size_t)transparency_stride(&render->set));
}

static bool make_buffer(Render *render, GLuint room)
{
    const GlContext *gl = render->gl;
    const GLuint head[LISTS_HEADS] = {[LISTS_WIDTH] = (GLuint)render->size[0],
                                      [LISTS_PIXELS] =
                                          (GLuint)render->size[0] * (GLuint)render->size[1],
                                      [LISTS_ROOM] = room};
    render->glass->lists.bytes = bytes_of(render, room);
    if (!render->glass->lists.buffer)
        gl->GenBuffers(1, &render->glass->lists.buffer);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, render->glass->lists.buffer);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)render->glass->lists.bytes, NULL,
                   GL_DYNAMIC_COPY);
    gl->BufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof head, head);
    return gl_check(render->gl, "making room for transparent fragments");
}

/* Draws without color and depth output: the programs write the lists themselves, and test depth
 * in the shader. */
static void draw(Render *render)
{
    static const GLenum none = GL_NONE;
    surface_draw_begin(render, &render->targets.draws[FRAME_DRAW_light], GL_GREATER);
    render->gl->DrawBuffers(1, &none);
    render->gl->DepthMask(GL_FALSE);
    texture_bind(render->gl, frame_texture(render, FRAME_TARGET_depth, 0),
                 render->glass->lists.depth_unit);
    surface_draw_objects(render, true);
    surface_draw_planes(render, true);
    render->gl->DepthMask(GL_TRUE);
    surface_draw_end(render);
}

static void pass_lists_draw(Render *render)
{
    const GlContext *gl = render->gl;
    const size_t heads = bytes_of(render, 0) - LISTS_COUNT * sizeof(GLuint);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, TRANSPARENCY_LISTS, render->glass->lists.buffer);
    gl->ClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, LISTS_COUNT * sizeof(GLuint),
                           (GLsizeiptr)heads, GL_RED_INTEGER, GL_UNSIGNED_INT, NULL);
    draw(render);
    gl->MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

/* Counts the fragments that no opaque surface hides, by drawing with a buffer without capacity.
 * Keeps the maximum of all tiles. */
static bool count_fragments(Render *render)
{
    GlContext *gl = render->gl;
    GLuint count = 0;
    pass_lists_draw(render);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, render->glass->lists.buffer);
    gl->GetBufferSubData(GL_SHADER_STORAGE_BUFFER, LISTS_COUNT * sizeof(GLuint), sizeof count,
                         &count);
    if (count > render->glass->lists.fragments)
        render->glass->lists.fragments = count;
    return gl_check(gl, "counting transparent fragments");
}

/* Allocates the lists, if within the memory limit. */
static bool make_room(Render *render)
{
    const GLuint count = render->glass->lists.fragments;
    const size_t most = transparency_most_bytes(render);
    render->glass->lists.full = bytes_of(render, count) > most;
    if (render->glass->lists.full)
        return gl_fail(
            render->gl, "%lu transparent fragments take %lu bytes in lists, and there may be %lu",
            (unsigned long)count, (unsigned long)bytes_of(render, count), (unsigned long)most);
    return make_buffer(render, count);
}

/* Counts fragments; fails without counting if even the heads of the lists exceed the limit. */
static bool pass_lists_count(Render *render, FrameCount step)
{
    if (step == FRAME_COUNT_wanted || step == FRAME_COUNT_again)
        return step == FRAME_COUNT_wanted;
    if (step == FRAME_COUNT_tile)
        return count_fragments(render);
    if (step == FRAME_COUNT_end)
        return make_room(render);
    render->glass->lists.fragments = 0;
    return bytes_of(render, 0) > transparency_most_bytes(render) ? make_room(render)
                                                                 : make_buffer(render, 0);
}

static bool pass_lists_make(Render *render)
{
    int units[2];
    if (!transparency_units(render, units))
        return false;
    render->glass->lists.depth_unit = units[0];
    transparency_set(render, "lists_depth", (float)units[0]);
    return true;
}

static bool pass_blend_make(Render *render)
{
    char reader[TRANSPARENCY_TEXT], veil[TRANSPARENCY_TEXT + sizeof "#define VEIL\n"];
    transparency_reader(&render->set, reader);
    snprintf(veil, sizeof veil, "#define VEIL\n%s", reader);
    return lighting_make(
               render, &(LightingText){{reader, render_text_pass_blend}, true, 0, LIGHTING_layers},
               &render->glass->blend) &&
           pass_tools_make_veil(
               render, &(LightingText){{veil, render_text_pass_blend}, true, 0, LIGHTING_layers});
}

/* Lists are sorted in place, so that the veil pass finds them sorted. */
static void pass_blend_draw(Render *render)
{
    render->gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, TRANSPARENCY_LISTS,
                               render->glass->lists.buffer);
    lighting_run(render, &(LightingSource){FRAME_TARGET_gbuffer, FRAME_TARGET_depth, 0},
                 &render->glass->blend);
    pass_tools_draw_veil(render);
}

static void pass_lists_delete(Render *render)
{
    render->gl->DeleteBuffers(1, &render->glass->lists.buffer); /* GL ignores the name 0 */
    render->glass->lists = (FrameLists){0};
}

/* Falls back to depth peeling if the lists exceed the memory limit, unless the user chose lists. */
static bool pass_lists_fall_back(Render *render)
{
    const char *method = render->options.transparency;
    if (!render->glass->lists.full || (method && !strcmp(method, "lists")))
        return false;
    render->transparency = TRANSPARENCY_peeling;
    return true;
}

void transparency_put_lists(Text *out, const Render *render)
{
    const FrameLists *lists = &render->glass->lists;
    if (lists->buffer)
        text_format(out, "%-8s  %-24s  4, and %d a fragment: %lu bytes for %lu\n", "lists",
                    "a buffer", 4 * transparency_stride(&render->set), (unsigned long)lists->bytes,
                    (unsigned long)lists->fragments);
    else
        text_format(out, "%-8s  %-24s  not there\n", "lists", "a buffer");
}

static void pass_blend_place(Render *render) { lighting_place(render, &render->glass->blend); }
static bool pass_blend_changed(Render *render, unsigned what)
{
    return lighting_changed(render, what, &render->glass->blend);
}
static void pass_blend_forget(Render *render) { frame_retire(render, &render->glass->blend); }

static bool pass_blend_moved(Render *render, int first, int count)
{
    (void)first, (void)count;
    lighting_moved(render, &render->glass->blend);
    return true;
}

const FramePass pass_lists = {
    .plan = {"lists", .reads = FRAME_BIT(depth), .fills = FRAME_BIT(lists)},
    .when = "something is transparent, and there is OpenGL 4.3",
    .needed = pass_lists_needed,
    .make = pass_lists_make,
    .count = pass_lists_count,
    .draw = pass_lists_draw,
    .fall_back = pass_lists_fall_back,
    .forget = pass_lists_delete,
};

const FramePass pass_blend = {
    .plan = {"blend", .reads = FRAME_BIT(lists), .changes = FRAME_BIT(light) | FRAME_BIT(tools)},
    .when = "there are lists",
    .needed = pass_lists_needed,
    .make = pass_blend_make,
    .draw = pass_blend_draw,
    .place = pass_blend_place,
    .changed = pass_blend_changed,
    .moved = pass_blend_moved,
    .forget = pass_blend_forget,
};
