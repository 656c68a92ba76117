/* Point light: emits from a point in all directions. */
#include "runtime/light_kinds/light_kind.h"
#include <string.h>

/* Draws a point light as three lines that cross at its position. */
static void light_point_outline(const SceneLight *light, LightLines *lines)
{
    for (int i = 0; i < 3; i++) {
        double ends[2][3];
        for (int k = 0; k < 2; k++) {
            memcpy(ends[k], light->position, sizeof ends[k]);
            ends[k][i] += (k - .5) * lines->size;
        }
        lines->add(lines, ends[0], ends[1]);
    }
}

const LightKind light_point = {
    .kind = SCENE_Point, .from = LIGHT_FROM_point, .outline = light_point_outline};
