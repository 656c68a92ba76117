/* Area light: a parallelogram of uniform radiance. */
#include "compiler/base/vec3.h"
#include "gen/render_text.h"
#include "runtime/light_kinds/light_kind.h"

static bool light_area_read(const LightParams *params, SceneLight *light, LightFault *fault)
{
    memcpy(light->edges[0], light_params_at(params, S_Area_u), sizeof light->edges[0]);
    memcpy(light->edges[1], light_params_at(params, S_Area_v), sizeof light->edges[1]);
    light->both_sides = *light_params_at(params, S_Area_bothSides) != 0;
    *fault = (LightFault){DIAG_scene_flat, S_Area_v, "u and v are parallel"};
    return vec3_span(light->edges[0], light->edges[1]);
}

/* Draws the edges, and a line from the center in the direction of emission. */
static void light_area_outline(const SceneLight *light, LightLines *lines)
{
    const double *u = light->edges[0], *v = light->edges[1], *p = light->position;
    double corners[4][3], middle[3], normal[3], end[3];
    vec3_cross(u, v, normal);
    vec3_normalize(normal);
    for (int i = 0; i < 3; i++) {
        corners[0][i] = p[i];
        corners[1][i] = p[i] + u[i];
        corners[2][i] = p[i] + u[i] + v[i];
        corners[3][i] = p[i] + v[i];
        middle[i] = p[i] + (u[i] + v[i]) / 2;
        end[i] = middle[i] + lines->size * normal[i];
    }
    for (int k = 0; k < 4; k++)
        lines->add(lines, corners[k], corners[(k + 1) % 4]);
    lines->add(lines, middle, end);
}

SceneLight light_area_new(void)
{
    return (SceneLight){.kind = SCENE_Area, .shadows = KEYWORD_Shadows_none};
}

const LightKind light_area = {.kind = SCENE_Area,
                              .from = LIGHT_FROM_extent,
                              .glsl = render_text_light_area,
                              .read = light_area_read,
                              .outline = light_area_outline};
