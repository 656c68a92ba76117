/* The answers of maps that are arithmetic between others. All work on colours; another group's lanes are the result's first. */
#include "compiler/oracle/oracle_maps.h"

/* A lane of the colour that a parameter's map is: the one of the channel, whatever its group. */
static double lane_at(Environment *environment, const Node *node, int param, int lane)
{
    return oracle_ask_param(environment, node, param, channel_id(GROUP_R, lane));
}

double oracle_Mix(Environment *environment, const Node *node, int channel)
{
    const int lane = lane_of(channel);
    const double t = lane_at(environment, node, P_Mix_amount, 0);
    return lane_at(environment, node, P_Mix_a, lane) * (1 - t) + lane_at(environment, node, P_Mix_b, lane) * t;
}

double oracle_Add(Environment *environment, const Node *node, int channel)
{
    const int lane = lane_of(channel);
    const double a = lane_at(environment, node, P_Add_a, lane);
    return lane == 3 ? a : a + lane_at(environment, node, P_Add_b, lane);
}

double oracle_Multiply(Environment *environment, const Node *node, int channel)
{
    const int lane = lane_of(channel);
    const double a = lane_at(environment, node, P_Multiply_a, lane);
    return lane == 3 ? a : a * lane_at(environment, node, P_Multiply_b, lane);
}

double oracle_Remap(Environment *environment, const Node *node, int channel)
{
    const double x = lane_at(environment, node, P_Remap_input, lane_of(channel));
    const double low = oracle_number(node, P_Remap_low), high = oracle_number(node, P_Remap_high);
    const double to_low = oracle_number(node, P_Remap_toLow), to_high = oracle_number(node, P_Remap_toHigh);
    if (lane_of(channel) == 3)
        return x;
    return low == high ? to_low : to_low + (to_high - to_low) * ((x - low) / (high - low));
}

double oracle_Contrast(Environment *environment, const Node *node, int channel)
{
    const double x = lane_at(environment, node, P_Contrast_input, lane_of(channel));
    const double pivot = oracle_number(node, P_Contrast_pivot);
    return lane_of(channel) == 3 ? x : pivot + oracle_number(node, P_Contrast_amount) * (x - pivot);
}

double oracle_Clamp(Environment *environment, const Node *node, int channel)
{
    const double x = lane_at(environment, node, P_Clamp_input, lane_of(channel));
    return lane_of(channel) == 3 ? x : fmin(fmax(x, oracle_number(node, P_Clamp_low)), oracle_number(node, P_Clamp_high));
}

double oracle_Power(Environment *environment, const Node *node, int channel)
{
    const double x = lane_at(environment, node, P_Power_input, lane_of(channel));
    return lane_of(channel) == 3 ? x : pow(fmax(x, 1e-37), oracle_number(node, P_Power_exponent));
}

double oracle_Combine(Environment *environment, const Node *node, int channel)
{
    return lane_of(channel) == 3 ? 1 : lane_at(environment, node, P_Combine_r + lane_of(channel), 0);
}

double oracle_Separate(Environment *environment, const Node *node, int channel)
{
    const int lane = (int)node_param(node, P_Separate_channel)->number[0] - (int)WORD_Channel_r;
    return lane_of(channel) == 3 ? 1 : lane_at(environment, node, P_Separate_input, lane);
}
