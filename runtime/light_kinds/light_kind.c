/* Functions shared by several kinds of lights. */
#include "runtime/light_kinds/light_kind.h"
#include "compiler/base/vec3.h"

const double *light_params_at(const LightParams *params, int param)
{
    return params->at[param - scene_kind_table[params->kind].first];
}

void light_kind_around(const SceneLight *light, const double angles[2], double distance,
                       double out[3])
{
    const double *d = light->direction, x[3] = {fabs(d[0]) < .9, fabs(d[0]) >= .9, 0};
    double u[3], v[3];
    vec3_cross(d, x, u);
    vec3_normalize(u);
    vec3_cross(d, u, v);
    for (int i = 0; i < 3; i++)
        out[i] = light->position[i] +
                 distance * (cos(angles[0]) * d[i] +
                             sin(angles[0]) * (cos(angles[1]) * u[i] + sin(angles[1]) * v[i]));
}
