/* Displacement in stages other than the fragment program: from attributes to matc_worldPosition,
 * by matc_displacement(). */
#include "compiler/emit/move.h"

/* Inputs of a vertex before displacement, from dedicated attributes. These are equal for all
 * vertices at one position, even where shading attributes differ (hard edges, texture seams), so
 * that the displaced mesh has no cracks. */
typedef struct {
    Input input;
    int attribute; /* index in move_attributes; -1: the position */
    const char *expression;
} MoveFeed;
const char *const move_attributes[MOVE_ATTRIBUTES] = {
    "vec3 displacementNormal", "vec2 displacementTexcoord", "vec3 displacementTangentU",
    "vec3 displacementTangentV"};
enum { MOVE_NORMAL, MOVE_TEXCOORD, MOVE_TANGENT_U, MOVE_TANGENT_V };
static const MoveFeed move_feeds[] = {
    {INPUT_vertexP, -1, "(matc_worldFromLocal * vec4(position, 1.0)).xyz"},
    {INPUT_vertexN, MOVE_NORMAL, "matc_worldNormalFromLocal * displacementNormal"},
    {INPUT_vertexDU, MOVE_TANGENT_U, "(matc_worldFromLocal * vec4(displacementTangentU, 0.0)).xyz"},
    {INPUT_vertexDV, MOVE_TANGENT_V, "(matc_worldFromLocal * vec4(displacementTangentV, 0.0)).xyz"},
    {INPUT_vertexU, MOVE_TEXCOORD, "displacementTexcoord"},
    {INPUT_vertexX, -1, "position"},
    {INPUT_vertexXU, MOVE_TANGENT_U, "displacementTangentU"},
    {INPUT_vertexXV, MOVE_TANGENT_V, "displacementTangentV"},
};
enum { MOVE_FEEDS = sizeof move_feeds / sizeof *move_feeds };

void move_mark(const VertexMove *move, bool attribute[MOVE_ATTRIBUTES])
{
    attribute[MOVE_NORMAL] = true;
    attribute[MOVE_TANGENT_U] = attribute[MOVE_TANGENT_V] = move->along_tangents;
    for (int i = 0; i < MOVE_FEEDS; i++)
        if (move->inputs[move_feeds[i].input] && move_feeds[i].attribute >= 0)
            attribute[move_feeds[i].attribute] = true;
}

void move_put_inputs(Text *out, const VertexMove *move)
{
    for (int i = 0; i < MOVE_FEEDS; i++)
        if (move->inputs[move_feeds[i].input] || move_feeds[i].input == INPUT_vertexP)
            text_format(out, "    %s = %s;\n", input_table[move_feeds[i].input].glsl,
                        move_feeds[i].expression);
}

void move_put(Text *out, const VertexMove *move)
{
    move_put_inputs(out, move);
    text_put(out, "    vec3 matc_up = matc_worldNormalFromLocal * displacementNormal;\n");
    if (move->volume) {
        text_put(out, "    vec4 matc_heights = matc_displacement();\n"
                      "    float matc_top = max(matc_heights.x < matc_heights.y ? matc_heights.y : "
                      "-1e30, matc_heights.z < matc_heights.w ? matc_heights.w : -1e30);\n"
                      "    matc_worldPosition += (matc_top > -1e30 ? matc_top : 0.0) * matc_up / "
                      "max(length(matc_up), 1e-30);\n");
        return;
    }
    if (!move->along_tangents) {
        text_put(out, "    matc_worldPosition += matc_displacement() * matc_up / "
                      "max(length(matc_up), 1e-30);\n");
        return;
    }
    text_put(
        out,
        "    vec3 matc_move = matc_displacement();\n"
        "    vec3 matc_alongU = (matc_worldFromLocal * vec4(displacementTangentU, 0.0)).xyz;\n"
        "    vec3 matc_alongV = (matc_worldFromLocal * vec4(displacementTangentV, 0.0)).xyz;\n"
        "    matc_worldPosition += matc_move.x * matc_alongU / max(length(matc_alongU), 1e-30)\n"
        "        + matc_move.y * matc_alongV / max(length(matc_alongV), 1e-30)\n"
        "        + matc_move.z * matc_up / max(length(matc_up), 1e-30);\n");
}
