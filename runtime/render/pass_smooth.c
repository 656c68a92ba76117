/* The passes smooth and spread: what rays found, as means over pixels of the same surface: along rows, then along columns, for all pixels of the picture. Their
 * GLSL is pass_smooth.glsl, behind indirect_place.glsl. */
#include "runtime/render/frame.h"

extern const char render_text_indirect_place[], render_text_pass_smooth[];

enum { SOURCE_UNIT = INDIRECT_FREE_UNIT, FOUND_UNIT };

/* The filter `atrous` goes to and fro between the targets smooth and open, an even number of times. */
static bool is_atrous(const Render *render)
{
    return render->scene->indirect.filter == WORD_Filter_atrous && indirect_coarse(render) == 1;
}

/* Two levels reach 6 pixels, four 30. */
static int atrous_levels(const Render *render)
{
    const int narrow = 6;
    return render->scene->indirect.filter_size > narrow ? 4 : 2;
}

bool pass_smooth_needed(const Render *render) { return indirect_is_smoothed(render); }

static bool make(Render *render, bool spread, ScreenPass *pass)
{
    char defined[INDIRECT_DEFINITIONS];
    indirect_define(render, defined);
    const ScreenPassText text = {.body = {indirect_surface_text(render), defined,
                                          is_atrous(render) ? "#define SMOOTH_ATROUS\n"
                                          : spread          ? "#define SMOOTH_SPREAD\n"
                                                            : "",
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

bool pass_smooth_make(Render *render) { return make(render, false, &render->indirect.smooth); }
bool pass_spread_make(Render *render) { return is_atrous(render) || make(render, true, &render->indirect.spread); }

/* What rays found. */
static GLuint found(const Render *render)
{
    return indirect_keeps(render) ? indirect_kept(render) : frame_texture(render, FRAME_TARGET_rays, 0);
}

static void run(Render *render, ScreenPass *pass, GLuint source, FrameDraw made)
{
    indirect_bind(render);
    texture_bind(render->gl, source, SOURCE_UNIT);
    if (is_atrous(render))
        texture_bind(render->gl, found(render), FOUND_UNIT);
    screen_pass_run(pass, &render->draws[made], &render->screen);
}

static void draw_level(Render *render, int level)
{
    ScreenPass *pass = &render->indirect.smooth;
    material_set_number(&pass->material, "smooth_level", (float)level);
    run(render, pass,
        level ? frame_texture(render, level % 2 ? FRAME_TARGET_smooth : FRAME_TARGET_open, 0) : found(render),
        level % 2 ? FRAME_DRAW_open : FRAME_DRAW_smooth);
}

void pass_smooth_draw(Render *render)
{
    if (is_atrous(render))
        draw_level(render, 0);
    else
        run(render, &render->indirect.smooth, found(render), FRAME_DRAW_smooth);
}

static void spread(Render *render)
{
    for (int level = 1; is_atrous(render) && level < atrous_levels(render); level++)
        draw_level(render, level);
    if (!is_atrous(render))
        run(render, &render->indirect.spread, frame_texture(render, FRAME_TARGET_smooth, 0), FRAME_DRAW_open);
}

/* Then all three once more for each further bounce: light that surfaces send is then that of lights and of the bounces before. */
void pass_spread_draw(Render *render)
{
    spread(render);
    for (int i = 1; indirect_is_repeated(render) && i < render->scene->indirect.bounces; i++) {
        pass_rays_draw_again(render);
        pass_smooth_draw(render);
        spread(render);
    }
}

void pass_smooth_request(const Render *render, void (*draw)(Render *), FramePlanPass *row)
{
    if (draw == pass_rays_draw && !indirect_is_smoothed(render))
        row->fills = 1u << FRAME_TARGET_open;
    if (draw == pass_smooth_draw && indirect_keeps(render))
        row->reads |= 1u << FRAME_TARGET_history;
    if (draw == pass_spread_draw && is_atrous(render))
        row->reads |= 1u << FRAME_TARGET_rays;
    if (draw == pass_spread_draw && indirect_is_repeated(render))
        row->reads |= 1u << FRAME_TARGET_rays | 1u << FRAME_TARGET_light | 1u << FRAME_TARGET_voxels;
}
