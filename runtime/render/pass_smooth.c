/* The passes smooth and spread: what rays found, as means over pixels of the same surface: along rows, then along columns, for all pixels of the picture. Their
 * GLSL is pass_smooth.glsl, behind indirect_place.glsl. */
#include "runtime/render/frame.h"

extern const char render_text_indirect_place[], render_text_pass_smooth[];

enum { SOURCE_UNIT = INDIRECT_FREE_UNIT };

bool pass_smooth_needed(const Render *render) { return indirect_is_smoothed(render); }

static bool make(Render *render, bool spread, ScreenPass *pass)
{
    char defined[INDIRECT_DEFINITIONS];
    indirect_define(render, defined);
    const ScreenPassText text = {.body = {indirect_surface_text(render), defined,
                                          spread ? "#define SMOOTH_SPREAD\n" : "", render_text_indirect_place,
                                          render_text_pass_smooth},
                                 .format = frame_format(render, FRAME_TARGET_open, 0),
                                 .compute = render->compute};
    if (!screen_pass_make(render->store, &text, pass))
        return false;
    screen_pass_sampler(pass, "smooth_source", SOURCE_UNIT);
    indirect_set(render, pass);
    return true;
}

bool pass_smooth_make(Render *render) { return make(render, false, &render->indirect.smooth); }
bool pass_spread_make(Render *render) { return make(render, true, &render->indirect.spread); }

static void run(Render *render, ScreenPass *pass, GLuint source, FrameDraw made)
{
    indirect_bind(render);
    texture_bind(render->gl, source, SOURCE_UNIT);
    screen_pass_run(pass, &render->draws[made], &render->screen);
}

void pass_smooth_draw(Render *render)
{
    const GLuint source = indirect_keeps(render) ? indirect_kept(render) : frame_texture(render, FRAME_TARGET_rays, 0);
    run(render, &render->indirect.smooth, source, FRAME_DRAW_smooth);
}

static void spread(Render *render)
{
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
    if (draw == pass_spread_draw && indirect_is_repeated(render))
        row->reads |= 1u << FRAME_TARGET_rays | 1u << FRAME_TARGET_light | 1u << FRAME_TARGET_voxels;
}
