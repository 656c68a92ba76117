/* Sky parameters of a SunSkyLight material. */
#include "compiler/graph/graph_sky.h"
#include "compiler/library/sky.h"

static const Node *node_of(const Node *node, int param)
{
    const Value *value = node_param(node, param);
    return value->kind == VALUE_node ? value->node : NULL;
}

/* Returns the material that lowering selects on the front side. */
static const Node *seen(const Node *m)
{
    while (m && (m->kind == KIND_SideSwitch || m->kind == KIND_AlgorithmSwitch)) {
        const bool side = m->kind == KIND_SideSwitch;
        const Node *first =
            node_of(m, side ? P_SideSwitch_frontShader : P_AlgorithmSwitch_guiShader);
        const Node *second = side || first ? first : node_of(m, P_AlgorithmSwitch_raytracerShader);
        m = side || second ? second : node_of(m, P_AlgorithmSwitch_radiationShader);
    }
    return m;
}

static double number_of(const Node *node, int param)
{
    double components[4];
    value_number(node_param(node, param), TYPE_float, components);
    return components[0];
}

bool graph_sky(const Node *material, GraphSky *sky)
{
    const Node *node = seen(material);
    double toward[4], rows[7][3];
    if (!node || node->kind != KIND_SunSkyLight)
        return false;
    const double turbidity = number_of(node, P_SunSkyLight_turbidity);
    const double factor = number_of(node, P_SunSkyLight_radianceFactor);
    value_number(node_param(node, P_SunSkyLight_sun), TYPE_vec3, toward);
    sky_coefficients(toward, turbidity, factor, rows);
    sky_sun(toward, turbidity, factor, sky->irradiance);
    for (int i = 0; i < 3; i++)
        sky->sun[i] = rows[6][i];
    sky->light = number_of(node, P_SunSkyLight_disableLight) == 0;
    sky->disc = number_of(node, P_SunSkyLight_disableSun) == 0;
    return true;
}
