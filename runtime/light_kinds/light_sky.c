/* Sky light: the scene's sky as a light. runtime/light/light_sky.c computes the data that its
 * GLSL reads. */
#include "gen/render_text.h"
#include "runtime/light_kinds/light_kind.h"

const LightKind light_sky = {
    .kind = SCENE_Sky, .from = LIGHT_FROM_sky, .glsl = render_text_light_sky};
