/* The pass rays: computes ambient occlusion and indirect light from depth, G-buffer, light and
 * voxels. Its GLSL is pass_rays.glsl, after indirect_place.glsl and that of the method. */
#include "gen/render_text.h"
#include "runtime/frame/frame.h"
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

static bool pass_rays_needed(const Render *render) { return indirect_is(render); }

static void pass_rays_place(Render *render)
{
    indirect_forget(render);
    FrameIndirect *in = render->indirect;
    enum { RAYS = 4 }; /* the first of the passes, which trace rays */
    ScreenPass *passes[] = {&in->rays,          &in->again,         &in->moving.rays,
                            &in->moving.again,  &in->smooth,        &in->spread,
                            &in->moving.smooth, &in->moving.spread, &in->history.blend,
                            &in->history.place};
    for (size_t i = 0; i < sizeof passes / sizeof *passes; i++)
        indirect_set(render, passes[i]);
    for (size_t i = 0; i < RAYS; i++)
        indirect_around_set(render, SKY_UNIT, passes[i]);
    for (size_t i = 0; i < RAYS && indirect_reads_voxels(render); i++)
        if (passes[i]->material.store) {
            pass_voxels_set(render, VOXEL_UNIT, passes[i]);
            indirect_planes_set(render, passes[i]);
        }
}

/* Pixels 8 apart along a row share a set of directions. Drivers that run invocations in vectors
 * trace all rays of a vector as far as the longest; equal directions make their lengths similar. */
static bool is_alike(const Render *render)
{
    return render->scene->indirect.rotation == WORD_Rotation_tile;
}

/* Adds the GLSL of pixel positions and voxels. */
static void add_places(const Render *render, ScreenPassText *text)
{
    const bool voxels = indirect_reads_voxels(render);
    if (voxels)
        screen_pass_add(text, "#define INDIRECT_VOXELS\n");
    if (indirect_reads_radiance(render))
        screen_pass_add(text, "#define INDIRECT_LEVELS\n");
    screen_pass_add(text, render_text_indirect_place);
    screen_pass_add(text, render_text_indirect_basis);
    if (voxels) {
        screen_pass_add(text, render_text_voxel_map);
        screen_pass_add(text, indirect_method(render)->ray);
    }
    screen_pass_add(text, render_text_indirect_lift);
}

/* Adds the GLSL of the method. */
static void add_method(const Render *render, ScreenPassText *text)
{
    const IndirectMethod *method = indirect_method(render);
    const bool seen = indirect_shows(render, "visibility"), rays = seen || !method->around;
    screen_pass_add(text, rays ? method->hit : method->around);
    if (rays)
        screen_pass_add(text, render_text_indirect_rays);
    screen_pass_add(text, seen ? render_text_indirect_seen : render_text_pass_rays);
}

/* Adds the unpacking of the surface; for a further bounce also its BRDF, by which pixels reflect
 * light again. */
static void add_surface(const Render *render, bool again, const char *defined, ScreenPassText *text)
{
    screen_pass_add(text, indirect_surface_text(render));
    if (again) {
        screen_pass_add(text, render->surface_lacks);
        screen_pass_add(text, render->surface->text);
        screen_pass_add_all(text, render->surface->more, SURFACE_MODEL_MORE);
    }
    screen_pass_add(text, defined);
    if (again)
        screen_pass_add(text, "#define INDIRECT_AGAIN\n");
}

static bool make(Render *render, bool again, int coarse, ScreenPass *pass)
{
    char defined[INDIRECT_DEFINITIONS], cached[RADIANCE_DEFINITIONS],
        planes[INDIRECT_PLANES_DEFINITION];
    char around[INDIRECT_AROUND_DEFINITION];
    const bool kept = radiance_needed(render);
    ScreenPassText text = {.format = frame_format(render, FRAME_TARGET_open, 0),
                           .compute = render->compute};
    indirect_define(render, coarse, defined);
    radiance_define(render, cached);
    indirect_planes_define(render, planes);
    add_surface(render, again, defined, &text);
    if (kept && is_alike(render))
        screen_pass_add(&text, "#define ENTRY_APART 8\n");
    add_places(render, &text);
    if (kept)
        screen_pass_add_all(&text, (const char *const[]){cached, render_text_radiance}, 2);
    indirect_around_add(render, around, &text);
    if (*planes)
        screen_pass_add_all(&text, (const char *const[]){planes, render_text_indirect_planes}, 2);
    add_method(render, &text);
    if (!screen_pass_make(render->store, &text, pass))
        return false;
    screen_pass_sampler(pass, "indirect_light", LIGHT_UNIT);
    screen_pass_sampler(pass, "indirect_before", BEFORE_UNIT);
    return true;
}

static bool pass_rays_make(Render *render)
{
    FrameIndirect *in = render->indirect;
    const bool again = indirect_is_repeated(render);
    const int coarse = indirect_coarse(render), moving = indirect_moving(render);
    const bool done = make(render, false, coarse, &in->rays) &&
                      (!again || make(render, true, coarse, &in->again)) &&
                      (!moving || make(render, false, moving, &in->moving.rays)) &&
                      (!moving || !again || make(render, true, moving, &in->moving.again));
    pass_rays_place(render);
    return done;
}

static void run(Render *render, ScreenPass *pass)
{
    const bool smoothed = indirect_is_smoothed(render);
    indirect_bind(render);
    if (render->targets.plan.there >> FRAME_TARGET_light & 1)
        texture_bind(render->gl, frame_texture(render, FRAME_TARGET_light, 0), LIGHT_UNIT);
    if (indirect_reads_voxels(render))
        voxel_bricks_bind(render, VOXEL_UNIT);
    if (radiance_needed(render)) {
        /* after the pass radiance, which may change its size */
        radiance_set(render, RADIANCE_UNIT, pass);
        radiance_bind(render, RADIANCE_UNIT);
    }
    indirect_around_bind(render, SKY_UNIT);
    const Framebuffer *target =
        &render->targets.draws[smoothed ? FRAME_DRAW_rays : FRAME_DRAW_open];
    screen_pass_run(pass, indirect_moves(render) ? &render->indirect->moving.found : target,
                    &render->screen);
}

void pass_rays_draw(Render *render)
{
    const unsigned most = 4096; /* sets with distinct shifts, which are computed in floats */
    if (indirect_moves(render)) {
        run(render, &render->indirect->moving.rays);
        return;
    }
    if (indirect_is_done(render))
        return;
    if (indirect_keeps(render))
        material_set_number(&render->indirect->rays.material, "indirect_set",
                            (float)(render->indirect->history.number % most));
    run(render, &render->indirect->rays);
}

void pass_rays_draw_again(Render *render)
{
    texture_bind(render->gl, frame_texture(render, FRAME_TARGET_open, 0), BEFORE_UNIT);
    run(render,
        indirect_moves(render) ? &render->indirect->moving.again : &render->indirect->again);
}

static bool pass_rays_changed(Render *render, unsigned what)
{
    pass_rays_place(render);
    indirect_doubt(render, what & RENDER_TIME     ? INDIRECT_DOUBT_light | INDIRECT_DOUBT_openness
                           : what & RENDER_LIGHTS ? INDIRECT_DOUBT_light
                                                  : 0);
    return true;
}

static bool pass_rays_moved(Render *render, int first, int count)
{
    (void)first, (void)count;
    pass_rays_place(render);
    indirect_doubt(render, INDIRECT_DOUBT_light);
    return true;
}

/* Without a denoiser the rays write the target `open` (ambient occlusion) directly. */
static void pass_rays_request(const Render *render, FramePlanPass *row)
{
    if (!indirect_is_smoothed(render))
        row->fills = FRAME_BIT(open);
}

static void pass_rays_drawn(Render *render) { render->indirect->moving.on = false; }

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
