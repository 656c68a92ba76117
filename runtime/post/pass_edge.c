/* The edge pass: computes the pixel coverage of silhouettes, creases and horizons for
 * antialiasing. Its GLSL is pass_edge.glsl; the tone pass blends by the result (edge_part.glsl).
 * Depths on both sides of a line decide whether the line is hidden. */
#include "gen/render_text.h"
#include "runtime/post/post.h"
#include "runtime/gpu_scene/edge_list.h"
#include <stdlib.h>
#include <string.h>

enum { LINES_IN_ROW = 1024, GROUP = 64, DEPTH_UNIT = 0, LINES_UNIT };

bool pass_edge_needed(const Render *render)
{
    return render->scene && render->compute && render->options.edges == RENDER_EDGES_coverage &&
           (!render->look || render->look->scene == FRAME_LOOK_faces);
}

const char *pass_edge_lacks(const Render *render)
{
    const bool asked = render->options.edges == RENDER_EDGES_coverage;
    if (!asked || render->compute)
        return NULL;
    return render->options.fragment ? "it takes compute, which is off"
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

static bool make_lines(Render *render)
{
    EdgeList list;
    GlContext *gl = render->gl;
    if (!edge_list_make(render->scene, &render->space, render->whole, &list))
        return gl_fail(gl, "out of memory");
    const int rows = list.count ? (list.count + LINES_IN_ROW - 1) / LINES_IN_ROW : 1;
    float *floats = texels_of(&list, rows);
    const TextureSpec spec = {
        .width = LINES_IN_ROW * EDGE_LIST_TEXELS, .height = rows, .lanes = 4, .floats = floats};
    gl->ActiveTexture(GL_TEXTURE0 + LINES_UNIT); /* texture_make binds the new texture */
    render->picture->edge.lines = floats && texture_check(gl, &spec) ? texture_make(gl, &spec) : 0;
    render->picture->edge.count = list.count;
    edge_list_free(&list);
    free(floats);
    return render->picture->edge.lines || (floats ? false : gl_fail(gl, "out of memory"));
}

static void pass_edge_place(Render *render)
{
    const float corner[4] = {(float)render->at[0], (float)render->at[1], (float)render->whole[0],
                             (float)render->whole[1]};
    if (render->picture->edge.material.store)
        material_set(&render->picture->edge.material, &(MaterialValue){"edge_corner", 4, corner});
}

static bool pass_edge_change(Render *render)
{
    if (!render->picture->edge.material.store)
        return true;
    render->gl->DeleteTextures(1, &render->picture->edge.lines);
    if (!make_lines(render))
        return false;
    material_set_number(&render->picture->edge.material, "edge_count",
                        (float)render->picture->edge.count);
    return true;
}

static bool pass_edge_make(Render *render)
{
    const bool newest = render->gl->major * 10 + render->gl->minor >= 45;
    const ProgramText text = {
        .compute = {newest ? "#version 450 core\n" : "#version 430 core\n", render_text_pass_edge}};
    if (!make_lines(render) ||
        !material_make(render->store, NULL, &text, &render->picture->edge.material))
        return false;
    material_set_number(&render->picture->edge.material, "edge_count",
                        (float)render->picture->edge.count);
    material_set_number(&render->picture->edge.material, "edge_depth", DEPTH_UNIT);
    material_set_number(&render->picture->edge.material, "edge_lines", LINES_UNIT);
    pass_edge_place(render);
    return true;
}

static void pass_edge_draw(Render *render)
{
    static const GLuint none[4];
    GlContext *gl = render->gl;
    frame_use(render, &render->targets.draws[FRAME_DRAW_edge]);
    gl->ClearBufferuiv(GL_COLOR, 0, none);
    if (!render->picture->edge.count)
        return;
    texture_bind(gl, frame_texture(render, FRAME_TARGET_depth, 0), DEPTH_UNIT);
    texture_bind(gl, render->picture->edge.lines, LINES_UNIT);
    material_use(&render->picture->edge.material);
    gl->BindImageTexture(0, frame_texture(render, FRAME_TARGET_edge, 0), 0, GL_FALSE, 0,
                         GL_READ_WRITE, GL_R32UI);
    gl->DispatchCompute(((GLuint)render->picture->edge.count + GROUP - 1) / GROUP, 1, 1);
    gl->MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

static void pass_edge_delete(Render *render)
{
    if (render->picture->edge.material.store)
        material_delete(&render->picture->edge.material);
    render->gl->DeleteTextures(1, &render->picture->edge.lines); /* GL ignores the name 0 */
    render->picture->edge = (FrameEdge){0};
}

static bool pass_edge_changed(Render *render, unsigned what)
{
    return !(what & RENDER_CAMERA) || pass_edge_change(render);
}

static bool pass_edge_moved(Render *render, int first, int count)
{
    (void)first, (void)count;
    return pass_edge_change(render);
}

const FramePass pass_edge = {
    .plan = {"edge", .reads = FRAME_BIT(depth), .fills = FRAME_BIT(edge)},
    .when = "edges are blended by coverage",
    .needed = pass_edge_needed,
    .lacks = pass_edge_lacks,
    .make = pass_edge_make,
    .draw = pass_edge_draw,
    .place = pass_edge_place,
    .changed = pass_edge_changed,
    .moved = pass_edge_moved,
    .forget = pass_edge_delete,
};
