/* The pass temporal: temporal accumulation of the rays' results, with rejection of samples of
 * other surfaces. Its targets are two of each kind, which swap every frame. Its GLSL is
 * pass_temporal.glsl, after indirect_place.glsl. */
#include "gen/render_text.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/indirect/filter/indirect_motion.h"
#include "runtime/indirect/rays/pass_rays.h"
#include "runtime/indirect/filter/pass_denoise.h"
#include "runtime/indirect/voxels/voxels.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { RAYS_UNIT = INDIRECT_FREE_UNIT, VALUES_UNIT, PLACES_UNIT, MOVED_UNIT };

static bool make_target(Renderer *renderer, Framebuffer *made)
{
    const FramebufferSpec spec = {.width = frame_edge(renderer, FRAME_TARGET_rays, 0),
                                  .height = frame_edge(renderer, FRAME_TARGET_rays, 1),
                                  .color_count = 1};
    return framebuffer_make_named(renderer->gl, &spec, (const char *const[]){"RGBA32F"}, made);
}

static bool make_pass(Renderer *renderer, bool place, ScreenPass *pass)
{
    char defined[INDIRECT_DEFINITIONS];
    indirect_define(renderer, indirect_coarse(renderer), defined);
    const ScreenPassText text = {.body = {indirect_surface_text(renderer), defined,
                                          place ? "#define TEMPORAL_PLACE\n" : "",
                                          render_text_indirect_place, render_text_pass_temporal},
                                 .format = "RGBA32F",
                                 .compute = renderer->compute};
    if (!screen_pass_make(renderer->store, &text, pass))
        return false;
    screen_pass_sampler(pass, "temporal_rays", RAYS_UNIT);
    screen_pass_sampler(pass, "temporal_values", VALUES_UNIT);
    screen_pass_sampler(pass, "temporal_places", PLACES_UNIT);
    screen_pass_sampler(pass, "temporal_moved", MOVED_UNIT);
    indirect_set(renderer, pass);
    return true;
}

static bool pass_temporal_make(Renderer *renderer)
{
    IndirectHistory *history = &renderer->indirect->history;
    bool done =
        make_pass(renderer, false, &history->blend) && make_pass(renderer, true, &history->place);
    for (int i = 0; done && i < 2; i++)
        done = make_target(renderer, &history->values[i]) &&
               make_target(renderer, &history->places[i]);
    return done && indirect_motion_make(renderer);
}

/* Inverts the eye's matrix, which is rigid: the inverse of its rotation is the transpose. */
static void invert_eye(const double eye[16], double made[16])
{
    memset(made, 0, 16 * sizeof *made);
    made[15] = 1;
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++) {
            made[4 * column + row] = eye[4 * row + column];
            made[12 + row] -= eye[4 * row + column] * eye[12 + column];
        }
}

static void put_product(const double a[16], const double b[16], float made[4][4])
{
    for (int column = 0; column < 4; column++)
        for (int row = 0; row < 4; row++) {
            double sum = 0;
            for (int k = 0; k < 4; k++)
                sum += a[4 * k + row] * b[4 * column + k];
            made[column][row] = (float)sum;
        }
}

/* Returns the distance from a moved object, in world units, within which ambient occlusion may
 * change: the length of a ray plus two voxels. */
static double reach_of(const Renderer *renderer)
{
    const double voxel = indirect_reads_voxels(renderer)
                             ? voxel_grid(renderer->scene, &renderer->gpu_scene).edge
                             : 0;
    return voxel_grid_radius(renderer->scene, &renderer->gpu_scene) + 2 * voxel;
}

static unsigned dirty_of(const Renderer *renderer)
{
    /* screen-space hits change with every move of the camera */
    const bool shown = !indirect_reads_radiance(renderer);
    return renderer->indirect->history.dirty |
           (shown ? INDIRECT_DIRTY_light | INDIRECT_DIRTY_ao : 0);
}

/* Returns the number of elements to write: data of moved objects is at the end. */
static int fill_block(Renderer *renderer, float (*block)[4])
{
    static const double one[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const IndirectHistory *history = &renderer->indirect->history;
    const unsigned dirty = dirty_of(renderer);
    double world_from_eye[16];
    invert_eye(renderer->space.eye_from_world, world_from_eye);
    put_product(one, world_from_eye, block + TEMPORAL_WORLD);
    put_product(history->eye_from_world, world_from_eye, block + TEMPORAL_FROM_EYE);
    memcpy(block[TEMPORAL_RAY], history->ray, sizeof *block);
    memcpy(block[TEMPORAL_VIEW], history->depth, sizeof *block);
    block[TEMPORAL_LIMITS][0] = (float)indirect_most_sets(renderer);
    block[TEMPORAL_LIMITS][1] = history->there;
    block[TEMPORAL_LIMITS][2] = history->still;
    block[TEMPORAL_DIRTY][0] = (dirty & INDIRECT_DIRTY_light) != 0;
    block[TEMPORAL_DIRTY][1] = (dirty & INDIRECT_DIRTY_ao) != 0;
    block[TEMPORAL_DIRTY][2] = (float)reach_of(renderer);
    const bool moved = history->there && !history->still &&
                       indirect_motion_draw(renderer, history->eye_from_world, block);
    return moved ? TEMPORAL_ALL : TEMPORAL_COUNTS + 1;
}

/* Adds one set of rays to the means. */
static void blend(Renderer *renderer)
{
    IndirectHistory *history = &renderer->indirect->history;
    const int next = 1 - history->last;
    float block[TEMPORAL_ALL][4] = {{0}};
    const size_t size = (size_t)fill_block(renderer, block) * sizeof *block;
    indirect_bind(renderer);
    texture_bind(renderer->gl, frame_texture(renderer, FRAME_TARGET_rays, 0), RAYS_UNIT);
    texture_bind(renderer->gl, history->values[history->last].colors[0], VALUES_UNIT);
    texture_bind(renderer->gl, history->places[history->last].colors[0], PLACES_UNIT);
    texture_bind(renderer->gl, renderer->indirect->motion.seen.colors[0], MOVED_UNIT);
    material_write(&history->blend.material, "History", block, size);
    material_write(&history->place.material, "History", block, size);
    screen_pass_run(&history->blend, &history->values[next], &renderer->screen);
    screen_pass_run(&history->place, &history->places[next], &renderer->screen);
    memcpy(history->eye_from_world, renderer->space.eye_from_world, sizeof history->eye_from_world);
    memcpy(history->ray, renderer->space.ray, sizeof history->ray);
    memcpy(history->depth, renderer->space.depth, sizeof history->depth);
    history->last = next;
    history->sets = history->still ? history->sets + 1 : 1;
    history->number++;
    history->there = history->still = true;
    history->dirty = 0;
    indirect_motion_end(renderer);
}

/* Estimates the error of the mean b, which has twice as many sets of rays as a. The mean of the
 * second half alone is 2 b - a, so b - a is half the difference of two independent means, and
 * that is about the error of their common mean. */
static double difference(const float *a, const float *b, size_t pixels)
{
    double sum = 0;
    for (size_t i = 0; i < pixels; i++)
        sum += ((double)b[4 * i + 3] - (double)a[4 * i + 3]) *
               ((double)b[4 * i + 3] - (double)a[4 * i + 3]);
    return sqrt(sum / (double)pixels);
}

/* Reports whether ambient occlusion has reached the wanted error. Called after 1, 2, 4, ...
 * sets. */
static bool is_exact(Renderer *renderer, float *means[2])
{
    IndirectHistory *history = &renderer->indirect->history;
    const Framebuffer *values = &history->values[history->last];
    const size_t pixels = (size_t)values->spec.width * (size_t)values->spec.height;
    float *before = means[0];
    means[0] = means[1];
    means[1] = before;
    return framebuffer_read(renderer->gl, values, 0, means[1]) && history->sets > 1 &&
           difference(means[0], means[1], pixels) <= renderer->scene->indirect.error;
}

static void pass_temporal_draw(Renderer *renderer)
{
    IndirectHistory *history = &renderer->indirect->history;
    const SceneIndirect *in = &renderer->scene->indirect;
    const size_t pixels =
        (size_t)history->values[0].spec.width * (size_t)history->values[0].spec.height;
    float *means[2] = {NULL, NULL};
    if (indirect_is_done(renderer) || indirect_moves(renderer))
        return;
    if (in->error > 0)
        for (int i = 0; i < 2; i++)
            means[i] = calloc(pixels, 4 * sizeof **means);
    for (int i = 0; i < in->samples && !indirect_is_done(renderer); i++) {
        if (i)
            pass_rays_draw(renderer);
        blend(renderer);
        if (means[0] && means[1] && !(history->sets & (history->sets - 1)))
            history->exact = is_exact(renderer, means);
    }
    free(means[0]);
    free(means[1]);
}

static bool pass_temporal_moved(Renderer *renderer, int first, int count)
{
    indirect_motion_add(renderer, first, count);
    return true;
}

const FramePass pass_temporal = {
    .plan = {"temporal",
             .reads = FRAME_BIT(depth) | FRAME_BIT(gbuffer) | FRAME_BIT(light) | FRAME_BIT(voxels) |
                      FRAME_BIT(radiance) | FRAME_BIT(rays),
             .fills = FRAME_BIT(temporal)},
    .when = "rays of several sets, or frames, count",
    .needed = indirect_keeps,
    .make = pass_temporal_make,
    .draw = pass_temporal_draw,
    .moved = pass_temporal_moved,
    .forget = indirect_motion_delete,
};
