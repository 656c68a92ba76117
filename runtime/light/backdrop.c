/* Backdrop of pixels without a surface: the pass tone shows it as it is, and the pass light adds
 * it behind transparent surfaces. */
#include "gen/render_text.h"
#include "runtime/frame_graph/transparency_draw.h"
#include "runtime/light/lighting.h"
#include <string.h>

static bool is_there(const Renderer *renderer)
{
    const char *view = renderer->options.view;
    return (renderer->scene->tiles || renderer->scene->glow) && !renderer->options.linear &&
           (!view || !strcmp(view, "final"));
}

const char *backdrop_text(const Renderer *renderer)
{
    return is_there(renderer) ? render_text_backdrop : "";
}

const char *backdrop_light_text(const Renderer *renderer)
{
    return transparency_is(renderer, renderer->transparency) ? backdrop_text(renderer) : "";
}

void backdrop_set(const Renderer *renderer, bool light, ScreenPass *pass)
{
    enum { TILE = 16 };
    const double most = 1e4; /* limit that keeps the scaled backdrop within half floats */
    const Scene *scene = renderer->scene;
    const bool tiles = scene->tiles && (light || !scene->glow);
    const double share = 1 / scene->exposure;
    const float place[4] = {(float)renderer->at[0], (float)renderer->at[1],
                            (float)renderer->whole[0], (float)renderer->whole[1]};
    material_set(&pass->material, &(MaterialValue){"backdrop_place", 4, place});
    material_set_number(&pass->material, "backdrop_tile",
                        (float)(tiles ? TILE * renderer->samples : 0));
    material_set_number(&pass->material, "backdrop_share", (float)(share < most ? share : most));
}
