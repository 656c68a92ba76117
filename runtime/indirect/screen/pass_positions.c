/* The pass positions: a view of the depth buffer's points as a mesh, from the side. Its own
 * depth buffer is the target that depth peeling uses for layers. Its GLSL is
 * positions_vertex.glsl and positions_fragment.glsl. */
#include "gen/render_text.h"
#include "runtime/frame/frame.h"
#include "runtime/frame/surface_draw.h"
#include "runtime/indirect/screen/pass_positions.h"
#include "runtime/indirect/voxels/voxels.h"
#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846

/* Views and their cameras, which orbit the center of all objects to the right or upwards. */
static const struct {
    const char *name;
    double right, up; /* degrees */
} views[] = {{"positions", 60, 0}, {"positions1", 0, 60}, {"positions2", -60, 0}};
enum { VIEWS = sizeof views / sizeof *views };

static int view_of(const char *view)
{
    for (int i = 0; view && i < VIEWS; i++)
        if (!strcmp(view, views[i].name))
            return i;
    return -1;
}

bool pass_positions_is_view(const char *view) { return view_of(view) >= 0; }
static bool pass_positions_needed(const Render *render)
{
    return pass_positions_is_view(render->options.view);
}

static void set(Render *render, const char *name, const float values[4])
{
    material_set(&render->positions->material, &(MaterialValue){name, 4, values});
}

/* Rotation about the center, by columns: points move left where the camera moves right; y is up,
 * z backwards. */
static void set_turn(Render *render, double right, double up)
{
    const double a = right * PI / 180, b = up * PI / 180;
    const float turn[9] = {(float)cos(a),           0,
                           (float)sin(a),           0,
                           (float)cos(b),           (float)sin(b),
                           (float)-sin(a),          (float)-sin(b),
                           (float)(cos(a) * cos(b))};
    material_set(&render->positions->material, &(MaterialValue){"positions_turn", 9, turn});
}

/* Sets the projection. An orthographic camera's depth range fits the original view, so it is
 * widened for the rotated points. */
static void set_clip(Render *render, const VoxelGrid *grid, const float middle[4])
{
    const float *m = render->space.spaces.clip_from_eye.m, *view = render->space.depth;
    const float reach = view[0] + 2 * (float)(grid->edge * grid->size),
                scale = render->zero_to_one ? 1 : 2;
    const float z = .5f * scale / reach, at = scale * (.5f - .5f * middle[2] / reach) - (scale - 1);
    const bool flat = view[1] > 0;
    set(render, "positions_clip", (float[]){m[0], m[5], flat ? z : m[10], flat ? at : m[14]});
}

static void pass_positions_place(Render *render)
{
    const int view = view_of(render->options.view);
    const float *m = render->space.spaces.clip_from_eye.m;
    const double *e = render->space.eye_from_world;
    float middle[4] = {0};
    if (!render->positions->material.store)
        return;
    const VoxelGrid grid = voxel_grid(render->scene, &render->gpu_scene);
    for (int row = 0; row < 3; row++) {
        double at = e[12 + row];
        for (int k = 0; k < 3; k++)
            at += e[4 * k + row] * (grid.low[k] + .5 * grid.edge * grid.size);
        middle[row] = (float)at;
    }
    set(render, "positions_middle", middle);
    set(render, "positions_ray", render->space.ray);
    set(render, "positions_view", render->space.depth);
    set_clip(render, &grid, middle);
    set(render, "positions_w", (float[]){m[11], m[15], 0, 0});
    set_turn(render, views[view].right, views[view].up);
}

static bool pass_positions_make(Render *render)
{
    const bool modern = render->gl->major * 10 + render->gl->minor >= 45;
    const char *head = modern ? "#version 450 core\n" : "#version 330 core\n";
    const ProgramText text = {.vertex = {head, render_text_positions_vertex},
                              .fragment = {head, render_text_positions_fragment}};
    if (!material_make(render->store, NULL, &text, &render->positions->material))
        return false;
    render->gl->GenVertexArrays(1, &render->positions->array);
    pass_positions_place(render);
    return true;
}

static void pass_positions_draw(Render *render)
{
    static const float none[4];
    const GlContext *gl = render->gl;
    const int squares = (render->size[0] - 1) * (render->size[1] - 1), vertices = 6;
    surface_draw_begin(render, &render->targets.draws[FRAME_DRAW_positions], GL_GREATER);
    gl->ClearBufferfv(GL_COLOR, 0, none);
    gl->ClearBufferfv(GL_DEPTH, 0, none);
    texture_bind(gl, frame_texture(render, FRAME_TARGET_depth, 0), 0);
    material_use(&render->positions->material);
    gl->BindVertexArray(render->positions->array);
    /* omits backs of surfaces, such as the wall of a room nearest to the camera */
    gl->Enable(GL_CULL_FACE);
    gl->DrawArrays(GL_TRIANGLES, 0, vertices * squares);
    gl->Disable(GL_CULL_FACE);
    gl->BindVertexArray(0);
    surface_draw_end(render);
}

static void pass_positions_delete(Render *render)
{
    material_delete(&render->positions->material);
    render->gl->DeleteVertexArrays(1, &render->positions->array); /* GL ignores the name 0 */
    *render->positions = (FramePositions){0};
}

static bool pass_positions_changed(Render *render, unsigned what)
{
    (void)what;
    pass_positions_place(render);
    return true;
}

const FramePass pass_positions = {
    .plan = {"mesh", .reads = FRAME_BIT(depth),
             .fills = FRAME_BIT(positions) | FRAME_BIT(layer_depth)},
    .when = "what the picture knows is looked at from beside",
    .needed = pass_positions_needed,
    .make = pass_positions_make,
    .draw = pass_positions_draw,
    .place = pass_positions_place,
    .changed = pass_positions_changed,
    .forget = pass_positions_delete,
};
