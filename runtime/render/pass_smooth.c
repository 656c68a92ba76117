/* The passes smooth and spread: what rays found, as means over pixels of the same surface: along rows, then along columns, for all pixels of the picture. Their
 * GLSL is pass_smooth.glsl, behind indirect_place.glsl. */
#include "runtime/render/frame.h"

extern const char render_text_indirect_place[], render_text_pass_smooth[];

enum { SOURCE_UNIT = INDIRECT_FREE_UNIT };

bool pass_smooth_needed(const Render *render)
{
    const SceneIndirect *in = &render->scene->indirect;
    return indirect_is(render) && (in->coarse > 1 || (in->filter != WORD_Filter_none && in->filter_size > 0));
}

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

static void run(Render *render, ScreenPass *pass, FrameTarget source, FrameDraw made)
{
    indirect_bind(render);
    texture_bind(render->gl, frame_texture(render, source, 0), SOURCE_UNIT);
    screen_pass_run(pass, &render->draws[made], &render->screen);
}

void pass_smooth_draw(Render *render) { run(render, &render->indirect.smooth, FRAME_TARGET_rays, FRAME_DRAW_smooth); }

void pass_spread_draw(Render *render) { run(render, &render->indirect.spread, FRAME_TARGET_smooth, FRAME_DRAW_open); }
