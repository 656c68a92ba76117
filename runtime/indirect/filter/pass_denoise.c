/* The passes denoise and upsample: means over pixels of the same surface, which remove noise
 * from the rays' results. The first filters along rows; the second filters along columns and
 * upsamples to all pixels of the picture. Their GLSL is pass_denoise.glsl, after
 * indirect_place.glsl. */
#include "gen/render_text.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/indirect/rays/pass_rays.h"
#include "runtime/indirect/filter/pass_denoise.h"

enum { SOURCE_UNIT = INDIRECT_FREE_UNIT, FOUND_UNIT };

/* The à-trous filter alternates between the targets denoise and ao, or a part of ao. At full
 * resolution it takes an even number of levels and ends in ao; otherwise it ends in denoise,
 * which is then upsampled. */
static bool is_atrous(const Renderer *renderer)
{
    return renderer->scene->indirect.filter == KEYWORD_Filter_atrous && !indirect_moves(renderer);
}

static bool is_spread(const Renderer *renderer)
{
    return !is_atrous(renderer) || indirect_coarse(renderer) > 1;
}

/* Returns the number of à-trous levels. At full resolution two levels reach 6 pixels and four
 * reach 30; at lower resolution one level reaches 2 pixels and three reach 14. */
static int atrous_levels(const Renderer *renderer)
{
    const int narrow = 6, odd = indirect_coarse(renderer) > 1;
    return (renderer->scene->indirect.filter_size > narrow ? 4 : 2) - odd;
}

int pass_denoise_reach(const Renderer *renderer)
{
    const int coarse = indirect_coarse(renderer), spread = coarse > 1 ? 2 : 0;
    const int reach = is_atrous(renderer) ? 2 * ((1 << atrous_levels(renderer)) - 1) + 1
                                          : indirect_filter_size(renderer, coarse);
    return indirect_is_smoothed(renderer) ? coarse * (reach + spread) : 0;
}

static bool pass_denoise_needed(const Renderer *renderer) { return indirect_is_smoothed(renderer); }

static bool make(Renderer *renderer, bool spread, int coarse, ScreenPass *pass)
{
    const bool atrous = is_atrous(renderer) && coarse == indirect_coarse(renderer);
    char defined[INDIRECT_DEFINITIONS];
    indirect_define(renderer, coarse, defined);
    const ScreenPassText text = {
        .body = {indirect_surface_text(renderer), defined,
                 atrous && !spread ? "#define SMOOTH_ATROUS\n" : "",
                 spread ? "#define SMOOTH_SPREAD\n" : "",
                 atrous && spread ? "#undef INDIRECT_FILTER\n#define INDIRECT_FILTER 0\n" : "",
                 render_text_indirect_place, render_text_pass_denoise},
        .format = frame_format(renderer, FRAME_TARGET_ao, 0),
        .compute = renderer->compute};
    if (!screen_pass_make(renderer->store, &text, pass))
        return false;
    screen_pass_sampler(pass, "smooth_source", SOURCE_UNIT);
    screen_pass_sampler(pass, "smooth_rays", FOUND_UNIT);
    indirect_set(renderer, pass);
    return true;
}

/* Makes a framebuffer of the part of a target that a lower resolution uses. */
static bool make_part(Renderer *renderer, FrameTarget target, int coarse, Framebuffer *made)
{
    const FramebufferSpec spec = {.width = (renderer->size[0] + coarse - 1) / coarse,
                                  .height = (renderer->size[1] + coarse - 1) / coarse,
                                  .color_count = 1};
    const FramebufferTextures textures = {.colors = {frame_texture(renderer, target, 0)},
                                          .formats = {frame_format(renderer, target, 0)}};
    return framebuffer_make_around(renderer->gl, &spec, &textures, made);
}

static bool pass_denoise_make(Renderer *renderer)
{
    IndirectMoving *moving = &renderer->indirect->moving;
    const int coarse = indirect_moving(renderer);
    return make(renderer, false, indirect_coarse(renderer), &renderer->indirect->smooth) &&
           (!coarse || (make(renderer, false, coarse, &moving->smooth) &&
                        make(renderer, true, coarse, &moving->spread) &&
                        make_part(renderer, FRAME_TARGET_rays, coarse, &moving->found) &&
                        make_part(renderer, FRAME_TARGET_denoise, coarse, &moving->smoothed)));
}

static bool pass_upsample_make(Renderer *renderer)
{
    const int coarse = indirect_coarse(renderer);
    return (!is_atrous(renderer) ||
            make_part(renderer, FRAME_TARGET_ao, coarse, &renderer->indirect->between)) &&
           (!is_spread(renderer) || make(renderer, true, coarse, &renderer->indirect->spread));
}

/* Returns the texture with the rays' results, accumulated if frames accumulate. */
static GLuint found(const Renderer *renderer)
{
    return indirect_keeps(renderer) && !indirect_moves(renderer)
               ? indirect_kept(renderer)
               : frame_texture(renderer, FRAME_TARGET_rays, 0);
}

static void run(Renderer *renderer, ScreenPass *pass, GLuint source, const Framebuffer *made)
{
    indirect_bind(renderer);
    texture_bind(renderer->gl, source, SOURCE_UNIT);
    if (is_atrous(renderer))
        texture_bind(renderer->gl, found(renderer), FOUND_UNIT);
    screen_pass_run(pass, made, &renderer->screen);
}

static void draw_level(Renderer *renderer, int level)
{
    ScreenPass *pass = &renderer->indirect->smooth;
    material_set_number(&pass->material, "smooth_level", (float)level);
    run(renderer, pass,
        level ? frame_texture(renderer, level % 2 ? FRAME_TARGET_denoise : FRAME_TARGET_ao, 0)
              : found(renderer),
        level % 2 ? &renderer->indirect->between : &renderer->targets.draws[FRAME_DRAW_denoise]);
}

static void pass_denoise_draw(Renderer *renderer)
{
    IndirectMoving *moving = &renderer->indirect->moving;
    if (is_atrous(renderer))
        draw_level(renderer, 0);
    else if (indirect_moves(renderer))
        run(renderer, &moving->smooth, found(renderer), &moving->smoothed);
    else
        run(renderer, &renderer->indirect->smooth, found(renderer),
            &renderer->targets.draws[FRAME_DRAW_denoise]);
}

static void spread(Renderer *renderer)
{
    for (int level = 1; is_atrous(renderer) && level < atrous_levels(renderer); level++)
        draw_level(renderer, level);
    if (is_spread(renderer))
        run(renderer,
            indirect_moves(renderer) ? &renderer->indirect->moving.spread
                                     : &renderer->indirect->spread,
            frame_texture(renderer, FRAME_TARGET_denoise, 0),
            &renderer->targets.draws[FRAME_DRAW_ao]);
}

/* Denoises, then repeats all three passes for each further bounce: surfaces then reflect the
 * light of lamps and of the bounces before. */
static void pass_upsample_draw(Renderer *renderer)
{
    spread(renderer);
    for (int i = 1; indirect_is_repeated(renderer) && i < renderer->scene->indirect.bounces; i++) {
        pass_rays_draw_again(renderer);
        pass_denoise_draw(renderer);
        spread(renderer);
    }
}

static void pass_denoise_request(const Renderer *renderer, FramePlanPass *row)
{
    row->reads |= indirect_keeps(renderer) ? FRAME_BIT(temporal) : 0;
}

/* The à-trous filter reads the rays for their standard deviation; a further bounce traces rays
 * itself. */
static void pass_upsample_request(const Renderer *renderer, FramePlanPass *row)
{
    if (is_atrous(renderer))
        row->reads |= FRAME_BIT(rays);
    if (indirect_is_repeated(renderer))
        row->reads |= FRAME_BIT(rays) | FRAME_BIT(light) | FRAME_BIT(voxels);
}

const FramePass pass_denoise = {
    .plan = {"denoise", .reads = FRAME_BIT(depth) | FRAME_BIT(gbuffer) | FRAME_BIT(rays),
             .fills = FRAME_BIT(denoise)},
    .when = "what rays found is smoothed",
    .needed = pass_denoise_needed,
    .request = pass_denoise_request,
    .make = pass_denoise_make,
    .draw = pass_denoise_draw,
};

const FramePass pass_upsample = {
    .plan = {"upsample", .reads = FRAME_BIT(depth) | FRAME_BIT(gbuffer) | FRAME_BIT(denoise),
             .fills = FRAME_BIT(ao)},
    .when = "what rays found is smoothed",
    .needed = pass_denoise_needed,
    .request = pass_upsample_request,
    .make = pass_upsample_make,
    .draw = pass_upsample_draw,
};
