/* The pass rays: computes ambient occlusion and indirect light from depth, G-buffer, light and
 * voxels. Its GLSL is pass_rays.glsl, after indirect_place.glsl and that of the method. */
#include "gen/render_text.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/indirect/rays/pass_rays.h"
#include "runtime/indirect/radiance/radiance.h"
#include "runtime/indirect/voxels/voxels.h"

enum {
    LIGHT_UNIT = INDIRECT_FREE_UNIT,
    VOXEL_UNIT,
    BEFORE_UNIT,
    RADIANCE_UNIT,
    SKY_UNIT = RADIANCE_UNIT + RADIANCE_UNITS
};

static bool pass_rays_needed(const Renderer *renderer) { return indirect_is(renderer); }

static void pass_rays_place(Renderer *renderer)
{
    indirect_forget(renderer);
    FrameIndirect *in = renderer->indirect;
    enum { RAYS = 4 }; /* number of passes that trace rays, the first of the passes */
    ScreenPass *passes[] = {&in->rays,          &in->again,         &in->moving.rays,
                            &in->moving.again,  &in->smooth,        &in->spread,
                            &in->moving.smooth, &in->moving.spread, &in->history.blend,
                            &in->history.place};
    for (size_t i = 0; i < sizeof passes / sizeof *passes; i++)
        indirect_set(renderer, passes[i]);
    for (size_t i = 0; i < RAYS; i++)
        indirect_around_set(renderer, SKY_UNIT, passes[i]);
    for (size_t i = 0; i < RAYS && indirect_reads_voxels(renderer); i++)
        if (passes[i]->material.store) {
            pass_voxels_set(renderer, VOXEL_UNIT, passes[i]);
            indirect_planes_set(renderer, passes[i]);
        }
}

/* Pixels 8 apart along a row share a set of directions. Drivers that run invocations in vectors
 * trace all rays of a vector as far as the longest; equal directions make their lengths similar. */
static bool is_alike(const Renderer *renderer)
{
    return renderer->scene->indirect.rotation == KEYWORD_Rotation_tile;
}

/* Adds the GLSL of pixel positions and voxels. */
static void add_places(const Renderer *renderer, ScreenPassText *text)
{
    const bool voxels = indirect_reads_voxels(renderer);
    if (voxels)
        screen_pass_add(text, "#define INDIRECT_VOXELS\n");
    if (indirect_reads_radiance(renderer))
        screen_pass_add(text, "#define INDIRECT_LEVELS\n");
    screen_pass_add(text, render_text_indirect_place);
    screen_pass_add(text, render_text_indirect_basis);
    if (voxels) {
        screen_pass_add(text, render_text_voxel_map);
        screen_pass_add(text, indirect_method(renderer)->ray);
    }
    screen_pass_add(text, render_text_indirect_lift);
}

/* Adds the GLSL of the method. */
static void add_method(const Renderer *renderer, ScreenPassText *text)
{
    const IndirectMethod *method = indirect_method(renderer);
    const bool seen = indirect_shows(renderer, "visibility"), rays = seen || !method->around;
    screen_pass_add(text, rays ? method->hit : method->around);
    if (rays)
        screen_pass_add(text, render_text_indirect_rays);
    screen_pass_add(text, seen ? render_text_indirect_seen : render_text_pass_rays);
}

/* Adds the unpacking of the surface; for a further bounce also its BRDF, by which pixels reflect
 * light again. */
static void add_surface(const Renderer *renderer, bool again, const char *defined,
                        ScreenPassText *text)
{
    screen_pass_add(text, indirect_surface_text(renderer));
    if (again) {
        screen_pass_add(text, renderer->surface_missing);
        screen_pass_add(text, renderer->surface->text);
        screen_pass_add_all(text, renderer->surface->more, SURFACE_MODEL_MORE);
    }
    screen_pass_add(text, defined);
    if (again)
        screen_pass_add(text, "#define INDIRECT_AGAIN\n");
}

static bool make(Renderer *renderer, bool again, int coarse, ScreenPass *pass)
{
    char defined[INDIRECT_DEFINITIONS], cached[RADIANCE_DEFINITIONS],
        planes[INDIRECT_PLANES_DEFINITION];
    char around[INDIRECT_AROUND_DEFINITION];
    const bool kept = radiance_needed(renderer);
    ScreenPassText text = {.format = frame_format(renderer, FRAME_TARGET_ao, 0),
                           .compute = renderer->compute};
    indirect_define(renderer, coarse, defined);
    radiance_define(renderer, cached);
    indirect_planes_define(renderer, planes);
    add_surface(renderer, again, defined, &text);
    if (kept && is_alike(renderer))
        screen_pass_add(&text, "#define ENTRY_APART 8\n");
    add_places(renderer, &text);
    if (kept)
        screen_pass_add_all(&text, (const char *const[]){cached, render_text_radiance}, 2);
    indirect_around_add(renderer, around, &text);
    if (*planes)
        screen_pass_add_all(&text, (const char *const[]){planes, render_text_indirect_planes}, 2);
    add_method(renderer, &text);
    if (!screen_pass_make(renderer->store, &text, pass))
        return false;
    screen_pass_sampler(pass, "indirect_light", LIGHT_UNIT);
    screen_pass_sampler(pass, "indirect_before", BEFORE_UNIT);
    return true;
}

static bool pass_rays_make(Renderer *renderer)
{
    FrameIndirect *in = renderer->indirect;
    const bool again = indirect_is_repeated(renderer);
    const int coarse = indirect_coarse(renderer), moving = indirect_moving(renderer);
    const bool done = make(renderer, false, coarse, &in->rays) &&
                      (!again || make(renderer, true, coarse, &in->again)) &&
                      (!moving || make(renderer, false, moving, &in->moving.rays)) &&
                      (!moving || !again || make(renderer, true, moving, &in->moving.again));
    pass_rays_place(renderer);
    return done;
}

static void run(Renderer *renderer, ScreenPass *pass)
{
    const bool smoothed = indirect_is_smoothed(renderer);
    indirect_bind(renderer);
    if (renderer->targets.plan.there >> FRAME_TARGET_light & 1)
        texture_bind(renderer->gl, frame_texture(renderer, FRAME_TARGET_light, 0), LIGHT_UNIT);
    if (indirect_reads_voxels(renderer))
        voxel_bricks_bind(renderer, VOXEL_UNIT);
    if (radiance_needed(renderer)) {
        /* set after the pass radiance, which may change the size of the cache */
        radiance_set(renderer, RADIANCE_UNIT, pass);
        radiance_bind(renderer, RADIANCE_UNIT);
    }
    indirect_around_bind(renderer, SKY_UNIT);
    const Framebuffer *target =
        &renderer->targets.draws[smoothed ? FRAME_DRAW_rays : FRAME_DRAW_ao];
    screen_pass_run(pass, indirect_moves(renderer) ? &renderer->indirect->moving.found : target,
                    &renderer->screen);
}

void pass_rays_draw(Renderer *renderer)
{
    const unsigned most = 4096; /* max sets with distinct shifts, which are computed in floats */
    if (indirect_moves(renderer)) {
        run(renderer, &renderer->indirect->moving.rays);
        return;
    }
    if (indirect_is_done(renderer))
        return;
    if (indirect_keeps(renderer))
        material_set_number(&renderer->indirect->rays.material, "indirect_set",
                            (float)(renderer->indirect->history.number % most));
    run(renderer, &renderer->indirect->rays);
}

void pass_rays_draw_again(Renderer *renderer)
{
    texture_bind(renderer->gl, frame_texture(renderer, FRAME_TARGET_ao, 0), BEFORE_UNIT);
    run(renderer,
        indirect_moves(renderer) ? &renderer->indirect->moving.again : &renderer->indirect->again);
}

static bool pass_rays_changed(Renderer *renderer, unsigned what)
{
    pass_rays_place(renderer);
    indirect_invalidate(renderer, what & RENDERER_TIME ? INDIRECT_DIRTY_light | INDIRECT_DIRTY_ao
                                  : what & RENDERER_LIGHTS ? INDIRECT_DIRTY_light
                                                           : 0);
    return true;
}

static bool pass_rays_moved(Renderer *renderer, int first, int count)
{
    (void)first, (void)count;
    pass_rays_place(renderer);
    indirect_invalidate(renderer, INDIRECT_DIRTY_light);
    return true;
}

/* Without a denoiser the rays write the target `ao` (ambient occlusion) directly. */
static void pass_rays_request(const Renderer *renderer, FramePlanPass *row)
{
    if (!indirect_is_smoothed(renderer))
        row->fills = FRAME_BIT(ao);
}

static void pass_rays_drawn(Renderer *renderer) { renderer->indirect->moving.on = false; }

const FramePass pass_rays = {
    .plan = {"rays",
             .reads = FRAME_BIT(depth) | FRAME_BIT(gbuffer) | FRAME_BIT(light) | FRAME_BIT(voxels) |
                      FRAME_BIT(radiance),
             .fills = FRAME_BIT(rays)},
    .when = "light is indirect",
    .needed = pass_rays_needed,
    .request = pass_rays_request,
    .make = pass_rays_make,
    .draw = pass_rays_draw,
    .drawn = pass_rays_drawn,
    .place = pass_rays_place,
    .changed = pass_rays_changed,
    .moved = pass_rays_moved,
    .forget = indirect_delete,
};
