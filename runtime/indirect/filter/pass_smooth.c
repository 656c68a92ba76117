/* The passes smooth and spread: denoise the rays' results, as means over pixels of the same
 * surface. Smooth filters along rows; spread filters along columns and upsamples to all pixels
 * of the picture. Their GLSL is pass_smooth.glsl, after indirect_place.glsl. */
#include "gen/render_text.h"
#include "runtime/frame/frame.h"
#include "runtime/indirect/rays/pass_rays.h"
#include "runtime/indirect/filter/pass_smooth.h"

enum { SOURCE_UNIT = INDIRECT_FREE_UNIT, FOUND_UNIT };

/* The à-trous filter alternates between the targets smooth and open, or a part of open. At full
 * resolution it takes an even number of levels and ends in open; otherwise it ends in smooth,
 * which is then upsampled. */
static bool is_atrous(const Render *render)
{
    return render->scene->indirect.filter == WORD_Filter_atrous && !indirect_moves(render);
}

static bool is_spread(const Render *render)
{
    return !is_atrous(render) || indirect_coarse(render) > 1;
}

/* Number of à-trous levels. At full resolution two levels reach 6 pixels and four reach 30; at
 * lower resolution one level reaches 2 pixels and three reach 14. */
static int atrous_levels(const Render *render)
{
    const int narrow = 6, odd = indirect_coarse(render) > 1;
    return (render->scene->indirect.filter_size > narrow ? 4 : 2) - odd;
}

int pass_smooth_reach(const Render *render)
{
    const int coarse = indirect_coarse(render), spread = coarse > 1 ? 2 : 0;
    const int reach = is_atrous(render) ? 2 * ((1 << atrous_levels(render)) - 1) + 1
                                        : indirect_filter_size(render, coarse);
    return indirect_is_smoothed(render) ? coarse * (reach + spread) : 0;
}

static bool pass_smooth_needed(const Render *render) { return indirect_is_smoothed(render); }

static bool make(Render *render, bool spread, int coarse, ScreenPass *pass)
{
    const bool atrous = is_atrous(render) && coarse == indirect_coarse(render);
    char defined[INDIRECT_DEFINITIONS];
    indirect_define(render, coarse, defined);
    const ScreenPassText text = {
        .body = {indirect_surface_text(render), defined,
                 atrous && !spread ? "#define SMOOTH_ATROUS\n" : "",
                 spread ? "#define SMOOTH_SPREAD\n" : "",
                 atrous && spread ? "#undef INDIRECT_FILTER\n#define INDIRECT_FILTER 0\n" : "",
                 render_text_indirect_place, render_text_pass_smooth},
        .format = frame_format(render, FRAME_TARGET_open, 0),
        .compute = render->compute};
    if (!screen_pass_make(render->store, &text, pass))
        return false;
    screen_pass_sampler(pass, "smooth_source", SOURCE_UNIT);
    screen_pass_sampler(pass, "smooth_rays", FOUND_UNIT);
    indirect_set(render, pass);
    return true;
}

/* Makes a framebuffer of the part of a target that a lower resolution uses. */
static bool make_part(Render *render, FrameTarget target, int coarse, Framebuffer *made)
{
    const FramebufferSpec spec = {.width = (render->size[0] + coarse - 1) / coarse,
                                  .height = (render->size[1] + coarse - 1) / coarse,
                                  .color_count = 1};
    const FramebufferTextures textures = {.colors = {frame_texture(render, target, 0)},
                                          .formats = {frame_format(render, target, 0)}};
    return framebuffer_make_around(render->gl, &spec, &textures, made);
}

static bool pass_smooth_make(Render *render)
{
    IndirectMoving *moving = &render->indirect->moving;
    const int coarse = indirect_moving(render);
    return make(render, false, indirect_coarse(render), &render->indirect->smooth) &&
           (!coarse || (make(render, false, coarse, &moving->smooth) &&
                        make(render, true, coarse, &moving->spread) &&
                        make_part(render, FRAME_TARGET_rays, coarse, &moving->found) &&
                        make_part(render, FRAME_TARGET_smooth, coarse, &moving->smoothed)));
}

static bool pass_spread_make(Render *render)
{
    const int coarse = indirect_coarse(render);
    return (!is_atrous(render) ||
            make_part(render, FRAME_TARGET_open, coarse, &render->indirect->between)) &&
           (!is_spread(render) || make(render, true, coarse, &render->indirect->spread));
}

/* Returns the texture with the rays' results, accumulated if frames accumulate. */
static GLuint found(const Render *render)
{
    return indirect_keeps(render) && !indirect_moves(render)
               ? indirect_kept(render)
               : frame_texture(render, FRAME_TARGET_rays, 0);
}

static void run(Render *render, ScreenPass *pass, GLuint source, const Framebuffer *made)
{
    indirect_bind(render);
    texture_bind(render->gl, source, SOURCE_UNIT);
    if (is_atrous(render))
        texture_bind(render->gl, found(render), FOUND_UNIT);
    screen_pass_run(pass, made, &render->screen);
}

static void draw_level(Render *render, int level)
{
    ScreenPass *pass = &render->indirect->smooth;
    material_set_number(&pass->material, "smooth_level", (float)level);
    run(render, pass,
        level ? frame_texture(render, level % 2 ? FRAME_TARGET_smooth : FRAME_TARGET_open, 0)
              : found(render),
        level % 2 ? &render->indirect->between : &render->targets.draws[FRAME_DRAW_smooth]);
}

static void pass_smooth_draw(Render *render)
{
    IndirectMoving *moving = &render->indirect->moving;
    if (is_atrous(render))
        draw_level(render, 0);
    else if (indirect_moves(render))
        run(render, &moving->smooth, found(render), &moving->smoothed);
    else
        run(render, &render->indirect->smooth, found(render),
            &render->targets.draws[FRAME_DRAW_smooth]);
}

static void spread(Render *render)
{
    for (int level = 1; is_atrous(render) && level < atrous_levels(render); level++)
        draw_level(render, level);
    if (is_spread(render))
        run(render,
            indirect_moves(render) ? &render->indirect->moving.spread : &render->indirect->spread,
            frame_texture(render, FRAME_TARGET_smooth, 0), &render->targets.draws[FRAME_DRAW_open]);
}

/* Denoises, then repeats all three passes for each further bounce: surfaces then reflect the
 * light of lamps and of the bounces before. */
static void pass_spread_draw(Render *render)
{
    spread(render);
    for (int i = 1; indirect_is_repeated(render) && i < render->scene->indirect.bounces; i++) {
        pass_rays_draw_again(render);
        pass_smooth_draw(render);
        spread(render);
    }
}

static void pass_smooth_request(const Render *render, FramePlanPass *row)
{
    row->reads |= indirect_keeps(render) ? FRAME_BIT(history) : 0;
}

/* The à-trous filter reads the rays for their standard deviation; a further bounce traces rays
 * itself. */
static void pass_spread_request(const Render *render, FramePlanPass *row)
{
    if (is_atrous(render))
        row->reads |= FRAME_BIT(rays);
    if (indirect_is_repeated(render))
        row->reads |= FRAME_BIT(rays) | FRAME_BIT(light) | FRAME_BIT(voxels);
}

const FramePass pass_smooth = {
    .plan = {"smooth", .reads = FRAME_BIT(depth) | FRAME_BIT(gbuffer) | FRAME_BIT(rays),
             .fills = FRAME_BIT(smooth)},
    .when = "what rays found is smoothed",
    .needed = pass_smooth_needed,
    .request = pass_smooth_request,
    .make = pass_smooth_make,
    .draw = pass_smooth_draw,
};

const FramePass pass_spread = {
    .plan = {"spread", .reads = FRAME_BIT(depth) | FRAME_BIT(gbuffer) | FRAME_BIT(smooth),
             .fills = FRAME_BIT(open)},
    .when = "what rays found is smoothed",
    .needed = pass_smooth_needed,
    .request = pass_spread_request,
    .make = pass_spread_make,
    .draw = pass_spread_draw,
};
