/* Evaluates arithmetic maps. All operate on colors; channels of another group are the result's
 * first components. */
#include "compiler/oracle/oracle_maps.h"

static const double MIN_WIDTH = 1e-30, MAX_EXPONENT = 64;

/* Returns a component of a parameter's color, that of the channel, whatever its group. */
static double component_at(Environment *environment, const Node *node, int param, int component)
{
    return oracle_query_param(environment, node, param, channel_id(GROUP_R, component));
}

double oracle_Mix(Environment *environment, const Node *node, int channel)
{
    const int component = component_of(channel);
    const double t = component_at(environment, node, P_Mix_amount, 0);
    return component_at(environment, node, P_Mix_a, component) * (1 - t) +
           component_at(environment, node, P_Mix_b, component) * t;
}

double oracle_Add(Environment *environment, const Node *node, int channel)
{
    const int component = component_of(channel);
    const double a = component_at(environment, node, P_Add_a, component);
    return component == 3 ? a : a + component_at(environment, node, P_Add_b, component);
}

double oracle_Multiply(Environment *environment, const Node *node, int channel)
{
    const int component = component_of(channel);
    const double a = component_at(environment, node, P_Multiply_a, component);
    return component == 3 ? a : a * component_at(environment, node, P_Multiply_b, component);
}

double oracle_Remap(Environment *environment, const Node *node, int channel)
{
    const double x = component_at(environment, node, P_Remap_input, component_of(channel));
    const double low = component_at(environment, node, P_Remap_low, 0),
                 high = component_at(environment, node, P_Remap_high, 0);
    const double to_low = component_at(environment, node, P_Remap_toLow, 0),
                 to_high = component_at(environment, node, P_Remap_toHigh, 0);
    if (component_of(channel) == 3)
        return x;
    return fabs(high - low) < MIN_WIDTH ? to_low
                                        : to_low + (to_high - to_low) * ((x - low) / (high - low));
}

double oracle_Contrast(Environment *environment, const Node *node, int channel)
{
    const double x = component_at(environment, node, P_Contrast_input, component_of(channel));
    const double pivot = component_at(environment, node, P_Contrast_pivot, 0);
    return component_of(channel) == 3
               ? x
               : pivot + component_at(environment, node, P_Contrast_amount, 0) * (x - pivot);
}

double oracle_Clamp(Environment *environment, const Node *node, int channel)
{
    const double x = component_at(environment, node, P_Clamp_input, component_of(channel));
    return component_of(channel) == 3
               ? x
               : fmin(fmax(x, component_at(environment, node, P_Clamp_low, 0)),
                      component_at(environment, node, P_Clamp_high, 0));
}

double oracle_Power(Environment *environment, const Node *node, int channel)
{
    const double x = component_at(environment, node, P_Power_input, component_of(channel));
    const double exponent =
        fmin(fmax(component_at(environment, node, P_Power_exponent, 0), 0), MAX_EXPONENT);
    return component_of(channel) == 3 ? x : fmin(pow(fmax(x, 1e-37), exponent), 1e37);
}

/* Converts RGB to HSV, hue in turns: the hexagon is the color cube viewed along its diagonal. */
static void hsv_of(const double rgb[3], double hsv[3])
{
    const double most = fmax(rgb[0], fmax(rgb[1], rgb[2])),
                 spread = most - fmin(rgb[0], fmin(rgb[1], rgb[2]));
    const double red = rgb[0], green = rgb[1], blue = rgb[2];
    double sixth = most == red ? green - blue : most == green ? blue - red : red - green;
    sixth = spread < 1e-30 ? 0 : sixth / spread + (most == red ? 0 : most == green ? 2 : 4);
    hsv[0] = sixth / 6 - floor(sixth / 6);
    hsv[1] = fabs(most) < 1e-30 ? 0 : spread / most;
    hsv[2] = most;
}

/* Returns a component of an HSV color: full within a sixth of a turn around its own hue, and
 * reduced by the saturation outside a third. */
static double component_of_hsv(const double hsv[3], int component)
{
    const double turn = hsv[0] - component / 3., from = fabs(turn - floor(turn + .5));
    return hsv[2] * (1 - hsv[1] * fmin(fmax(6 * from - 1, 0), 1));
}

double oracle_HSV(Environment *environment, const Node *node, int channel)
{
    double rgb[3], hsv[3];
    if (component_of(channel) == 3)
        return component_at(environment, node, P_HSV_input, 3);
    for (int i = 0; i < 3; i++)
        rgb[i] = component_at(environment, node, P_HSV_input, i);
    hsv_of(rgb, hsv);
    hsv[0] += component_at(environment, node, P_HSV_hue, 0);
    hsv[1] *= component_at(environment, node, P_HSV_saturation, 0);
    hsv[2] *= component_at(environment, node, P_HSV_value, 0);
    return component_of_hsv(hsv, component_of(channel));
}

/* Evaluates the chosen map's own channel, whatever its group. */
double oracle_Switch(Environment *environment, const Node *node, int channel)
{
    const Value *maps = node_param(node, P_Switch_maps);
    if (maps->kind != VALUE_items || !maps->items->count)
        return component_of(channel) == 3;
    const double i = floor(component_at(environment, node, P_Switch_which, 0) + .5);
    return oracle_query(environment,
                        maps->items->item[(int)fmin(fmax(i, 0), maps->items->count - 1)].input,
                        channel);
}

double oracle_Combine(Environment *environment, const Node *node, int channel)
{
    return component_of(channel) == 3
               ? 1
               : component_at(environment, node, P_Combine_r + component_of(channel), 0);
}

double oracle_Separate(Environment *environment, const Node *node, int channel)
{
    const int component =
        (int)node_param(node, P_Separate_channel)->number[0] - (int)KEYWORD_Channel_r;
    return component_of(channel) == 3
               ? 1
               : component_at(environment, node, P_Separate_input, component);
}
