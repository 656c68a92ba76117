/* Spot light: a point light with a cone. */
#include "runtime/light_kinds/light_kind.h"
#include <math.h>

#define PI 3.14159265358979323846

static bool light_spot_read(const LightParams *params, SceneLight *light, LightFault *fault)
{
    const double inner = *light_params_at(params, S_Spot_innerAngle);
    const double outer = *light_params_at(params, S_Spot_outerAngle);
    light->inner_cosine = cos(inner * (PI / 180));
    light->outer_cosine = cos(outer * (PI / 180));
    *fault = (LightFault){DIAG_scene_cone, S_Spot_innerAngle, NULL};
    return inner <= outer;
}

/* Sets scale and shift of the cone's factor, which is linear in the cosine between the angles. A
 * cone with equal angles has the steepest slope that its cosine resolves. */
static void light_spot_cone(const SceneLight *light, double scale_shift[2])
{
    const double width = fmax(light->inner_cosine - light->outer_cosine, 1e-6);
    scale_shift[0] = 1 / width;
    scale_shift[1] = -light->outer_cosine / width;
}

/* Draws the outer cone: edges, and the circle through their ends. */
static void light_spot_outline(const SceneLight *light, LightLines *lines)
{
    enum { STEPS = 32, EDGES = 4 };
    const double angle = acos(light->outer_cosine);
    for (int i = 0; i < STEPS; i++) {
        double ends[2][3];
        for (int k = 0; k < 2; k++)
            light_kind_around(light, (double[]){angle, 2 * PI * (i + k) / STEPS}, lines->size,
                              ends[k]);
        lines->add(lines, ends[0], ends[1]);
        if (i % (STEPS / EDGES) == 0)
            lines->add(lines, light->position, ends[0]);
    }
}

const LightKind light_spot = {.kind = SCENE_Spot,
                              .from = LIGHT_FROM_point,
                              .read = light_spot_read,
                              .cone = light_spot_cone,
                              .outline = light_spot_outline};
