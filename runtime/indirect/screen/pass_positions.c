/* The pass positions: a view of the depth buffer's points as a mesh, from the side. Its own
 * depth buffer is the target that depth peeling uses for layers. Its GLSL is
 * positions_vertex.glsl and positions_fragment.glsl. */
#include "gen/render_text.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/frame_graph/surface_draw.h"
#include "runtime/indirect/screen/pass_positions.h"
#include "runtime/indirect/voxels/voxels.h"
#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846

/* Views and their cameras, which orbit the center of all objects to the right or upwards. */
static const struct {
    const char *name;
    double right, up; /* angles in degrees */
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
static bool pass_positions_needed(const Renderer *renderer)
{
    return pass_positions_is_view(renderer->options.view);
}

static void set(Renderer *renderer, const char *name, const float values[4])
{
    material_set(&renderer->positions->material, &(MaterialValue){name, 4, values});
}

/* Rotation about the center, by columns: points move left where the camera moves right; y is up,
 * z backwards. */
static void set_turn(Renderer *renderer, double right, double up)
{
    const double a = right * PI / 180, b = up * PI / 180;
    const float turn[9] = {(float)cos(a),           0,
                           (float)sin(a),           0,
                           (float)cos(b),           (float)sin(b),
                           (float)-sin(a),          (float)-sin(b),
                           (float)(cos(a) * cos(b))};
    material_set(&renderer->positions->material, &(MaterialValue){"positions_turn", 9, turn});
}

/* Sets the projection. An orthographic camera's depth range fits the original view, so it is
 * widened for the rotated points. */
static void set_clip(Renderer *renderer, const VoxelGrid *grid, const float middle[4])
{
    const float *m = renderer->space.spaces.clip_from_eye.m, *view = renderer->space.depth;
    const float reach = view[0] + 2 * (float)(grid->edge * grid->size),
                scale = renderer->zero_to_one ? 1 : 2;
    const float z = .5f * scale / reach, at = scale * (.5f - .5f * middle[2] / reach) - (scale - 1);
    const bool flat = view[1] > 0;
    set(renderer, "positions_clip", (float[]){m[0], m[5], flat ? z : m[10], flat ? at : m[14]});
}

static void pass_positions_place(Renderer *renderer)
{
    const int view = view_of(renderer->options.view);
    const float *m = renderer->space.spaces.clip_from_eye.m;
    const double *e = renderer->space.eye_from_world;
    float middle[4] = {0};
    if (!renderer->positions->material.store)
        return;
    const VoxelGrid grid = voxel_grid(renderer->scene, &renderer->gpu_scene);
    for (int row = 0; row < 3; row++) {
        double at = e[12 + row];
        for (int k = 0; k < 3; k++)
            at += e[4 * k + row] * (grid.low[k] + .5 * grid.edge * grid.size);
        middle[row] = (float)at;
    }
    set(renderer, "positions_middle", middle);
    set(renderer, "positions_ray", renderer->space.ray);
    set(renderer, "positions_view", renderer->space.depth);
    set_clip(renderer, &grid, middle);
    set(renderer, "positions_w", (float[]){m[11], m[15], 0, 0});
    set_turn(renderer, views[view].right, views[view].up);
}

static bool pass_positions_make(Renderer *renderer)
{
    const bool modern = renderer->gl->major * 10 + renderer->gl->minor >= 45;
    const char *head = modern ? "#version 450 core\n" : "#version 330 core\n";
    const ProgramText text = {.vertex = {head, render_text_positions_vertex},
                              .fragment = {head, render_text_positions_fragment}};
    if (!material_make(renderer->store, NULL, &text, &renderer->positions->material))
        return false;
    renderer->gl->GenVertexArrays(1, &renderer->positions->array);
    pass_positions_place(renderer);
    return true;
}

static void pass_positions_draw(Renderer *renderer)
{
    static const float none[4];
    const GlContext *gl = renderer->gl;
    const int squares = (renderer->size[0] - 1) * (renderer->size[1] - 1), vertices = 6;
    surface_draw_begin(renderer, &renderer->targets.draws[FRAME_DRAW_positions], GL_GREATER);
    gl->ClearBufferfv(GL_COLOR, 0, none);
    gl->ClearBufferfv(GL_DEPTH, 0, none);
    texture_bind(gl, frame_texture(renderer, FRAME_TARGET_depth, 0), 0);
    material_use(&renderer->positions->material);
    gl->BindVertexArray(renderer->positions->array);
    /* omits backs of surfaces, such as the wall of a room nearest to the camera */
    gl->Enable(GL_CULL_FACE);
    gl->DrawArrays(GL_TRIANGLES, 0, vertices * squares);
    gl->Disable(GL_CULL_FACE);
    gl->BindVertexArray(0);
    surface_draw_end(renderer);
}

static void pass_positions_delete(Renderer *renderer)
{
    material_delete(&renderer->positions->material);
    renderer->gl->DeleteVertexArrays(1, &renderer->positions->array); /* GL ignores the name 0 */
    *renderer->positions = (FramePositions){0};
}

static bool pass_positions_changed(Renderer *renderer, unsigned what)
{
    (void)what;
    pass_positions_place(renderer);
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
