/* Ambient light: weights the slot `ambient` of every surface, without a direction. */
#include "gen/render_text.h"
#include "runtime/light_kinds/light_kind.h"

const LightKind light_ambient = {
    .kind = SCENE_Ambient, .from = LIGHT_FROM_around, .glsl = render_text_light_ambient};
