/* The passes lists and blend: store transparent fragments in per-pixel linked lists, and
 * composite these over the light. Their GLSL is lists_store.glsl, which follows the materials'
 * own, and pass_blend.glsl. */
#include "gen/lists_layout.h"
#include "gen/render_text.h"
#include "runtime/frame_graph/surface_draw.h"
#include "runtime/frame_graph/transparency_draw.h"
#include "runtime/transparency/transparency_passes.h"
#include "runtime/post/post.h"
#include <stdio.h>
#include <string.h>

static bool pass_lists_needed(const Renderer *renderer)
{
    return transparency_is(renderer, TRANSPARENCY_lists);
}

static size_t bytes_of(const Renderer *renderer, GLuint fragments)
{
    const size_t pixels = (size_t)renderer->size[0] * (size_t)renderer->size[1];
    return sizeof(GLuint) *
           (LISTS_HEADS + pixels + (size_t)fragments * (size_t)transparency_stride(&renderer->set));
}

static bool make_buffer(Renderer *renderer, GLuint capacity)
{
    const GlContext *gl = renderer->gl;
    const GLuint head[LISTS_HEADS] = {[LISTS_WIDTH] = (GLuint)renderer->size[0],
                                      [LISTS_PIXELS] =
                                          (GLuint)renderer->size[0] * (GLuint)renderer->size[1],
                                      [LISTS_CAPACITY] = capacity};
    renderer->transparent->lists.bytes = bytes_of(renderer, capacity);
    if (!renderer->transparent->lists.buffer)
        gl->GenBuffers(1, &renderer->transparent->lists.buffer);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, renderer->transparent->lists.buffer);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)renderer->transparent->lists.bytes, NULL,
                   GL_DYNAMIC_COPY);
    gl->BufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof head, head);
    return gl_check(renderer->gl, "making room for transparent fragments");
}

/* Draws without color and depth output: the programs write the lists themselves, and test depth
 * in the shader. */
static void draw(Renderer *renderer)
{
    static const GLenum none = GL_NONE;
    surface_draw_begin(renderer, &renderer->targets.draws[FRAME_DRAW_light], GL_GREATER);
    renderer->gl->DrawBuffers(1, &none);
    renderer->gl->DepthMask(GL_FALSE);
    texture_bind(renderer->gl, frame_texture(renderer, FRAME_TARGET_depth, 0),
                 renderer->transparent->lists.depth_unit);
    surface_draw_objects(renderer, true);
    surface_draw_planes(renderer, true);
    renderer->gl->DepthMask(GL_TRUE);
    surface_draw_end(renderer);
}

static void pass_lists_draw(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    const size_t heads = bytes_of(renderer, 0) - LISTS_COUNT * sizeof(GLuint);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, TRANSPARENCY_LISTS,
                       renderer->transparent->lists.buffer);
    gl->ClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, LISTS_COUNT * sizeof(GLuint),
                           (GLsizeiptr)heads, GL_RED_INTEGER, GL_UNSIGNED_INT, NULL);
    draw(renderer);
    gl->MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

/* Counts the fragments that no opaque surface hides, by drawing with a buffer without capacity.
 * Keeps the maximum of all tiles. */
static bool count_fragments(Renderer *renderer)
{
    GlContext *gl = renderer->gl;
    GLuint count = 0;
    pass_lists_draw(renderer);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, renderer->transparent->lists.buffer);
    gl->GetBufferSubData(GL_SHADER_STORAGE_BUFFER, LISTS_COUNT * sizeof(GLuint), sizeof count,
                         &count);
    if (count > renderer->transparent->lists.fragments)
        renderer->transparent->lists.fragments = count;
    return gl_check(gl, "counting transparent fragments");
}

/* Allocates the lists, if within the memory limit. */
static bool make_capacity(Renderer *renderer)
{
    const GLuint count = renderer->transparent->lists.fragments;
    const size_t most = transparency_most_bytes(renderer);
    renderer->transparent->lists.full = bytes_of(renderer, count) > most;
    if (renderer->transparent->lists.full)
        return gl_fail(
            renderer->gl, "%lu transparent fragments take %lu bytes in lists, and there may be %lu",
            (unsigned long)count, (unsigned long)bytes_of(renderer, count), (unsigned long)most);
    return make_buffer(renderer, count);
}

/* Counts fragments; fails without counting if even the heads of the lists exceed the limit. */
static bool pass_lists_count(Renderer *renderer, FrameCount step)
{
    if (step == FRAME_COUNT_wanted || step == FRAME_COUNT_again)
        return step == FRAME_COUNT_wanted;
    if (step == FRAME_COUNT_tile)
        return count_fragments(renderer);
    if (step == FRAME_COUNT_end)
        return make_capacity(renderer);
    renderer->transparent->lists.fragments = 0;
    return bytes_of(renderer, 0) > transparency_most_bytes(renderer) ? make_capacity(renderer)
                                                                     : make_buffer(renderer, 0);
}

static bool pass_lists_make(Renderer *renderer)
{
    int units[2];
    if (!transparency_units(renderer, units))
        return false;
    renderer->transparent->lists.depth_unit = units[0];
    transparency_set(renderer, "lists_depth", (float)units[0]);
    return true;
}

static bool pass_blend_make(Renderer *renderer)
{
    char reader[TRANSPARENCY_TEXT], veil[TRANSPARENCY_TEXT + sizeof "#define VEIL\n"];
    transparency_reader(&renderer->set, reader);
    snprintf(veil, sizeof veil, "#define VEIL\n%s", reader);
    return lighting_make(
               renderer,
               &(LightingText){{reader, render_text_pass_blend}, true, 0, LIGHTING_layers},
               &renderer->transparent->blend) &&
           pass_tools_make_veil(
               renderer, &(LightingText){{veil, render_text_pass_blend}, true, 0, LIGHTING_layers});
}

/* Lists are sorted in place, so that the debug views' transparent layer finds them sorted. */
static void pass_blend_draw(Renderer *renderer)
{
    renderer->gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, TRANSPARENCY_LISTS,
                                 renderer->transparent->lists.buffer);
    lighting_run(renderer, &(LightingSource){FRAME_TARGET_gbuffer, FRAME_TARGET_depth, 0},
                 &renderer->transparent->blend);
    pass_tools_draw_veil(renderer);
}

static void pass_lists_delete(Renderer *renderer)
{
    renderer->gl->DeleteBuffers(1,
                                &renderer->transparent->lists.buffer); /* GL ignores the name 0 */
    renderer->transparent->lists = (FrameLists){0};
}

/* Falls back to depth peeling if the lists exceed the memory limit, unless the user chose lists. */
static bool pass_lists_fall_back(Renderer *renderer)
{
    const char *method = renderer->options.transparency;
    if (!renderer->transparent->lists.full || (method && !strcmp(method, "lists")))
        return false;
    renderer->transparency = TRANSPARENCY_peeling;
    return true;
}

void transparency_put_lists(Text *out, const Renderer *renderer)
{
    const FrameLists *lists = &renderer->transparent->lists;
    if (lists->buffer)
        text_format(out, "%-13s  %-24s  4, and %d a fragment: %lu bytes for %lu\n", "lists",
                    "a buffer", 4 * transparency_stride(&renderer->set),
                    (unsigned long)lists->bytes, (unsigned long)lists->fragments);
    else
        text_format(out, "%-13s  %-24s  not allocated\n", "lists", "a buffer");
}

static void pass_blend_place(Renderer *renderer)
{
    lighting_place(renderer, &renderer->transparent->blend);
}
static bool pass_blend_changed(Renderer *renderer, unsigned what)
{
    return lighting_changed(renderer, what, &renderer->transparent->blend);
}
static void pass_blend_forget(Renderer *renderer)
{
    frame_retire(renderer, &renderer->transparent->blend);
}

static bool pass_blend_moved(Renderer *renderer, int first, int count)
{
    (void)first, (void)count;
    lighting_moved(renderer, &renderer->transparent->blend);
    return true;
}

const FramePass pass_lists = {
    .plan = {"lists", .reads = FRAME_BIT(depth), .fills = FRAME_BIT(lists)},
    .when = "the scene has transparent surfaces, and OpenGL 4.3 is supported",
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
