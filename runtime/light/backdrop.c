/* Backdrop of pixels without a surface: the pass tone shows it as it is, and the pass light adds
 * it behind transparent surfaces. */
#include "gen/render_text.h"
#include "runtime/frame/transparency_draw.h"
#include "runtime/light/lighting.h"
#include <string.h>

static bool is_there(const Render *render)
{
    const char *view = render->options.view;
    return (render->scene->tiles || render->scene->glow) && !render->options.linear &&
           (!view || !strcmp(view, "shown"));
}

const char *backdrop_text(const Render *render)
{
    return is_there(render) ? render_text_backdrop : "";
}

const char *backdrop_light_text(const Render *render)
{
    return transparency_is(render, render->transparency) ? backdrop_text(render) : "";
}

void backdrop_set(const Render *render, bool light, ScreenPass *pass)
{
    enum { TILE = 16 };
    const double most = 1e4; /* keeps the scaled backdrop within half floats */
    const Scene *scene = render->scene;
    const bool tiles = scene->tiles && (light || !scene->glow);
    const double share = 1 / scene->exposure;
    const float place[4] = {(float)render->at[0], (float)render->at[1], (float)render->whole[0],
                            (float)render->whole[1]};
    material_set(&pass->material, &(MaterialValue){"backdrop_place", 4, place});
    material_set_number(&pass->material, "backdrop_tile",
                        (float)(tiles ? TILE * render->samples : 0));
    material_set_number(&pass->material, "backdrop_share", (float)(share < most ? share : most));
}
