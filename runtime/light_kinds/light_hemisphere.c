/* Hemisphere light: light from all directions, brighter from above than from below. */
#include "gen/render_text.h"
#include "runtime/light_kinds/light_kind.h"
#include <string.h>

static bool light_hemisphere_read(const LightParams *params, SceneLight *light, LightFault *fault)
{
    (void)fault;
    for (int i = 0; i < 3; i++)
        light->ground[i] = light_params_at(params, S_Hemisphere_ground)[i] *
                           *light_params_at(params, S_Hemisphere_intensity);
    return true;
}

SceneLight light_hemisphere_new(const double light[3], const double ground[3])
{
    SceneLight made = {
        .kind = SCENE_Hemisphere, .direction = {0, 0, -1}, .shadows = KEYWORD_Shadows_none};
    memcpy(made.light, light, sizeof made.light);
    memcpy(made.ground, ground, sizeof made.ground);
    return made;
}

const LightKind light_hemisphere = {.kind = SCENE_Hemisphere,
                                    .from = LIGHT_FROM_around,
                                    .varies = true,
                                    .glsl = render_text_light_hemisphere,
                                    .read = light_hemisphere_read};
