/* Directional light: parallel light from infinitely far. */
#include "runtime/light_kinds/light_kind.h"
#include <string.h>

#define PI 3.14159265358979323846

/* Draws an arrow that ends at the world's origin, as the light has no position. */
static void light_directional_outline(const SceneLight *light, LightLines *lines)
{
    enum { BARBS = 4 };
    const double *d = light->direction;
    SceneLight tip = {.direction = {-d[0], -d[1], -d[2]}};
    double end[3];
    memcpy(tip.position, lines->zero, sizeof tip.position);
    light_kind_around(&tip, (double[]){0, 0}, 4 * lines->size, end);
    lines->add(lines, end, tip.position);
    for (int i = 0; i < BARBS; i++) {
        light_kind_around(&tip, (double[]){PI / 8, 2 * PI * i / BARBS}, lines->size, end);
        lines->add(lines, end, tip.position);
    }
}

SceneLight light_directional_new(const double direction[3], const double light[3])
{
    SceneLight made = {.kind = SCENE_Directional, .shadows = KEYWORD_Shadows_none};
    memcpy(made.direction, direction, sizeof made.direction);
    memcpy(made.light, light, sizeof made.light);
    return made;
}

const LightKind light_directional = {
    .kind = SCENE_Directional, .from = LIGHT_FROM_afar, .outline = light_directional_outline};
