/* The edge pass: computes the pixel coverage of silhouettes, creases and horizons for
 * antialiasing. Its GLSL is pass_edge.glsl; the tone pass blends by the result (edge_part.glsl).
 * Depths on both sides of a line decide whether the line is hidden. */
#include "gen/render_text.h"
#include "runtime/post/post.h"
#include "runtime/gpu_scene/edge_list.h"
#include <stdlib.h>
#include <string.h>

enum { LINES_IN_ROW = 1024, GROUP = 64, DEPTH_UNIT = 0, LINES_UNIT };

bool pass_edge_needed(const Renderer *renderer)
{
    return renderer->scene && renderer->compute &&
           renderer->options.edges == RENDERER_EDGES_coverage &&
           (!renderer->look || renderer->look->scene == FRAME_LOOK_faces);
}

const char *pass_edge_missing(const Renderer *renderer)
{
    const bool asked = renderer->options.edges == RENDERER_EDGES_coverage;
    if (!asked || renderer->compute)
        return NULL;
    return renderer->options.fragment ? "it takes compute, which is off"
                                      : "it takes compute, which the driver lacks";
}

/* Returns the lines padded to full texture rows. */
static float *texels_of(const EdgeList *list, int rows)
{
    float *floats = calloc((size_t)rows * LINES_IN_ROW, sizeof *list->lines);
    if (floats && list->count)
        memcpy(floats, list->lines, (size_t)list->count * sizeof *list->lines);
    return floats;
}

static bool make_lines(Renderer *renderer)
{
    EdgeList list;
    GlContext *gl = renderer->gl;
    if (!edge_list_make(renderer->scene, &renderer->space, renderer->whole, &list))
        return gl_fail(gl, "out of memory");
    const int rows = list.count ? (list.count + LINES_IN_ROW - 1) / LINES_IN_ROW : 1;
    float *floats = texels_of(&list, rows);
    const TextureSpec spec = {.width = LINES_IN_ROW * EDGE_LIST_TEXELS,
                              .height = rows,
                              .components = 4,
                              .floats = floats};
    gl->ActiveTexture(GL_TEXTURE0 + LINES_UNIT); /* texture_make binds the new texture */
    renderer->post->edge.lines = floats && texture_check(gl, &spec) ? texture_make(gl, &spec) : 0;
    renderer->post->edge.count = list.count;
    edge_list_free(&list);
    free(floats);
    return renderer->post->edge.lines || (floats ? false : gl_fail(gl, "out of memory"));
}

static void pass_edge_place(Renderer *renderer)
{
    const float corner[4] = {(float)renderer->at[0], (float)renderer->at[1],
                             (float)renderer->whole[0], (float)renderer->whole[1]};
    if (renderer->post->edge.material.store)
        material_set(&renderer->post->edge.material, &(MaterialValue){"edge_corner", 4, corner});
}

static bool pass_edge_change(Renderer *renderer)
{
    if (!renderer->post->edge.material.store)
        return true;
    renderer->gl->DeleteTextures(1, &renderer->post->edge.lines);
    if (!make_lines(renderer))
        return false;
    material_set_number(&renderer->post->edge.material, "edge_count",
                        (float)renderer->post->edge.count);
    return true;
}

static bool pass_edge_make(Renderer *renderer)
{
    const bool newest = renderer->gl->major * 10 + renderer->gl->minor >= 45;
    const ProgramText text = {
        .compute = {newest ? "#version 450 core\n" : "#version 430 core\n", render_text_pass_edge}};
    if (!make_lines(renderer) ||
        !material_make(renderer->store, NULL, &text, &renderer->post->edge.material))
        return false;
    material_set_number(&renderer->post->edge.material, "edge_count",
                        (float)renderer->post->edge.count);
    material_set_number(&renderer->post->edge.material, "edge_depth", DEPTH_UNIT);
    material_set_number(&renderer->post->edge.material, "edge_lines", LINES_UNIT);
    pass_edge_place(renderer);
    return true;
}

static void pass_edge_draw(Renderer *renderer)
{
    static const GLuint none[4];
    GlContext *gl = renderer->gl;
    frame_use(renderer, &renderer->targets.draws[FRAME_DRAW_edge]);
    gl->ClearBufferuiv(GL_COLOR, 0, none);
    if (!renderer->post->edge.count)
        return;
    texture_bind(gl, frame_texture(renderer, FRAME_TARGET_depth, 0), DEPTH_UNIT);
    texture_bind(gl, renderer->post->edge.lines, LINES_UNIT);
    material_use(&renderer->post->edge.material);
    gl->BindImageTexture(0, frame_texture(renderer, FRAME_TARGET_edge, 0), 0, GL_FALSE, 0,
                         GL_READ_WRITE, GL_R32UI);
    gl->DispatchCompute(((GLuint)renderer->post->edge.count + GROUP - 1) / GROUP, 1, 1);
    gl->MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

static void pass_edge_delete(Renderer *renderer)
{
    if (renderer->post->edge.material.store)
        material_delete(&renderer->post->edge.material);
    renderer->gl->DeleteTextures(1, &renderer->post->edge.lines); /* GL ignores the name 0 */
    renderer->post->edge = (FrameEdge){0};
}

static bool pass_edge_changed(Renderer *renderer, unsigned what)
{
    return !(what & RENDERER_CAMERA) || pass_edge_change(renderer);
}

static bool pass_edge_moved(Renderer *renderer, int first, int count)
{
    (void)first, (void)count;
    return pass_edge_change(renderer);
}

const FramePass pass_edge = {
    .plan = {"edge", .reads = FRAME_BIT(depth), .fills = FRAME_BIT(edge)},
    .when = "edges are blended by coverage",
    .needed = pass_edge_needed,
    .lacks = pass_edge_missing,
    .make = pass_edge_make,
    .draw = pass_edge_draw,
    .place = pass_edge_place,
    .changed = pass_edge_changed,
    .moved = pass_edge_moved,
    .forget = pass_edge_delete,
};
