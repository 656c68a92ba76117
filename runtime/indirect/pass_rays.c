/* The pass rays: from depth, G-buffer, light and voxels to openness and indirect light. Its GLSL is pass_rays.glsl, behind indirect_place.glsl and that of the
 * method. */
#include "runtime/frame/frame.h"
#include "runtime/indirect/indirect.h"
#include "runtime/indirect/radiance.h"
#include "runtime/indirect/voxels.h"

extern const char render_text_indirect_place[], render_text_indirect_march[], render_text_indirect_near[],
    render_text_indirect_mask[], render_text_indirect_points[], render_text_indirect_rays[],
    render_text_indirect_seen[], render_text_indirect_basis[], render_text_indirect_lift[], render_text_pass_rays[],
    render_text_voxel_map[], render_text_voxel_march[], render_text_voxel_ray[], render_text_radiance[], render_text_indirect_planes[];

enum {
    LIGHT_UNIT = INDIRECT_FREE_UNIT,
    VOXEL_UNIT,
    BEFORE_UNIT,
    RADIANCE_UNIT,
    SKY_UNIT = RADIANCE_UNIT + RADIANCE_UNITS
};

bool pass_rays_needed(const Render *render) { return indirect_is(render); }

void pass_rays_place(Render *render)
{
    indirect_forget(render);
    FrameIndirect *in = &render->indirect;
    enum { RAYS = 4 }; /* of them send rays */
    ScreenPass *passes[] = {&in->rays,          &in->again,         &in->moving.rays,   &in->moving.again,  &in->smooth, &in->spread,
                            &in->moving.smooth, &in->moving.spread, &in->history.blend, &in->history.place};
    for (size_t i = 0; i < sizeof passes / sizeof *passes; i++)
        indirect_set(render, passes[i]);
    for (size_t i = 0; i < RAYS; i++)
        indirect_around_set(render, SKY_UNIT, passes[i]);
    for (size_t i = 0; i < RAYS && indirect_reads_voxels(render); i++)
        if (passes[i]->material.store) {
            pass_voxels_set(render, VOXEL_UNIT, passes[i]);
            radiance_set(render, RADIANCE_UNIT, passes[i]);
            indirect_planes_set(render, passes[i]);
        }
}

/* Pixels so far apart along a row have one set of directions: their rays are alike, as those of neighbours are not, and drivers that run invocations in vectors walk all of a vector's rays as far
 * as the longest. */
static bool is_alike(const Render *render) { return render->scene->indirect.rotation == WORD_Rotation_tile; }

static bool make(Render *render, bool again, int coarse, ScreenPass *pass)
{
    char defined[INDIRECT_DEFINITIONS], cached[RADIANCE_DEFINITIONS], planes[INDIRECT_PLANES_DEFINITION];
    const char *around[INDIRECT_AROUND_TEXTS];
    const bool kept = radiance_needed(render);
    const bool voxels = indirect_reads_voxels(render), levels = indirect_reads_radiance(render),
               seen = indirect_shows(render, "visibility"),
               points = !seen && indirect_method(render) == WORD_Indirect_points,
               mask = !seen && indirect_method(render) == WORD_Indirect_screen;
    indirect_define(render, coarse, defined);
    radiance_define(render, cached);
    indirect_planes_define(render, planes);
    indirect_around_texts(render, around);
    const SurfaceModel none = {.text = ""}, *of = again ? render->surface : &none;
    const ScreenPassText text = {.body = {indirect_surface_text(render),
                                          again ? render->surface_lacks : "",
                                          of->text,
                                          surface_model_more(of, 0),
                                          surface_model_more(of, 1),
                                          surface_model_more(of, 2),
                                          surface_model_more(of, 3),
                                          surface_model_more(of, 4),
                                          surface_model_more(of, 5),
                                          surface_model_more(of, 6),
                                          surface_model_more(of, 7),
                                          defined,
                                          again ? "#define INDIRECT_AGAIN\n" : "",
                                          kept && is_alike(render) ? "#define ENTRY_APART 8\n" : "",
                                          levels   ? "#define INDIRECT_VOXELS\n#define INDIRECT_LEVELS\n"
                                          : voxels ? "#define INDIRECT_VOXELS\n"
                                                   : "",
                                          render_text_indirect_place,
                                          render_text_indirect_basis,
                                          voxels ? render_text_voxel_map : "",
                                          levels   ? render_text_voxel_ray
                                          : voxels ? render_text_voxel_march
                                                   : "",
                                          render_text_indirect_lift,
                                          kept ? cached : "",
                                          kept ? render_text_radiance : "",
                                          around[0],
                                          around[1],
                                          around[2],
                                          planes,
                                          *planes ? render_text_indirect_planes : "",
                                          mask     ? render_text_indirect_mask
                                          : points ? render_text_indirect_points
                                          : levels ? render_text_indirect_near
                                                   : render_text_indirect_march,
                                          mask || points ? "" : render_text_indirect_rays,
                                          seen ? render_text_indirect_seen : render_text_pass_rays},
                                 .format = frame_format(render, FRAME_TARGET_open, 0),
                                 .compute = render->compute};
    if (!screen_pass_make(render->store, &text, pass))
        return false;
    screen_pass_sampler(pass, "indirect_light", LIGHT_UNIT);
    screen_pass_sampler(pass, "indirect_before", BEFORE_UNIT);
    return true;
}

bool pass_rays_make(Render *render)
{
    FrameIndirect *in = &render->indirect;
    const bool again = indirect_is_repeated(render);
    const int coarse = indirect_coarse(render), moving = indirect_moving(render);
    const bool done = make(render, false, coarse, &in->rays) && (!again || make(render, true, coarse, &in->again)) &&
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
    if (radiance_needed(render))
        radiance_bind(render, RADIANCE_UNIT);
    indirect_around_bind(render, SKY_UNIT);
    const Framebuffer *target = &render->targets.draws[smoothed ? FRAME_DRAW_rays : FRAME_DRAW_open];
    screen_pass_run(pass, indirect_moves(render) ? &render->indirect.moving.found : target, &render->screen);
}

void pass_rays_draw(Render *render)
{
    const unsigned most = 4096; /* sets that differ: what they are shifted by is a float */
    if (indirect_moves(render)) {
        run(render, &render->indirect.moving.rays);
        return;
    }
    if (indirect_is_done(render))
        return;
    if (indirect_keeps(render))
        material_set_number(&render->indirect.rays.material, "indirect_set",
                            (float)(render->indirect.history.number % most));
    run(render, &render->indirect.rays);
}

void pass_rays_draw_again(Render *render)
{
    texture_bind(render->gl, frame_texture(render, FRAME_TARGET_open, 0), BEFORE_UNIT);
    run(render, indirect_moves(render) ? &render->indirect.moving.again : &render->indirect.again);
}
