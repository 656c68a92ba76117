/* Textures and inputs for ir_eval. */
#include "evaluate.h"
#include "compiler/library/carpenter.h"
#include <string.h>

static const float *bake(Arena *arena, const IrTexture *t)
{
    double n[4];
    float *floats = arena_alloc(arena, sizeof *floats * (size_t)t->width * (size_t)t->height);
    for (int k = 0; k < 4; k++) {
        double lanes[4];
        value_number(&t->node->params[1 + k], TYPE_float, lanes);
        n[k] = lanes[0];
    }
    const CarpenterRelief carpenter = {n[0], n[1], n[2], (int64_t)n[3], t->width, t->height};
    carpenter_bake(&carpenter, floats);
    return floats;
}

bool evaluate_textures(Arena *arena, const Ir *ir, ReferenceTexture textures[EVALUATE_TEXTURES])
{
    if (ir->texture_count > EVALUATE_TEXTURES)
        return false;
    for (size_t i = 0; i < ir->texture_count; i++) {
        const IrTexture *t = &ir->textures[i];
        textures[i] = (ReferenceTexture){.width = t->width, .height = t->height, .lanes = 1};
        if (t->kind == TEXTURE_image) {
            textures[i].lanes = 4;
            textures[i].bytes = image_bytes(t->image);
            textures[i].words = image_words(t->image);
            textures[i].floats = image_floats(t->image);
            textures[i].srgb = t->srgb;
            textures[i].wrap = (ReferenceWrap)(t->wrap - WORD_Address_repeat);
            textures[i].sampler_wraps = true;
        } else {
            textures[i].floats = bake(arena, t);
        }
    }
    return true;
}

void evaluate_inputs(const Point *point, bool front, double inputs[INPUT_COUNT][4])
{
    memset(inputs, 0, sizeof(double[INPUT_COUNT][4]));
    for (int i = 0; i < POINT_VARYINGS; i++)
        for (int lane = 0; lane < 3; lane++)
            inputs[i][lane] = point->input[i][lane];
    inputs[INPUT_front][0] = front;
    inputs[INPUT_IOR][0] = point_ior;
    inputs[INPUT_time][0] = point_time;
    memcpy(inputs[INPUT_viewer], point_viewer, sizeof point_viewer);
}

void evaluate_bends(const Point *point, double inputs[INPUT_COUNT][4])
{
    static const Input texture[2] = {INPUT_UX, INPUT_UY}, normal[2] = {INPUT_NX, INPUT_NY};
    /* to the right neighbour, to the upper one */
    static const double uv[2][2] = {{0.5, 0}, {0.125, -0.25}};
    static const Input tangents[2][2] = {{INPUT_DUX, INPUT_DUY}, {INPUT_DVX, INPUT_DVY}};
    double by[2][3], swings[2][2][3];
    point_bends(point, by[0], by[1]);
    point_swings(point, swings);
    for (int to = 0; to < 2; to++) {
        memcpy(inputs[texture[to]], uv[to], sizeof uv[to]);
        for (int lane = 0; lane < 3; lane++)
            inputs[normal[to]][lane] = uv[to][0] * by[0][lane] + uv[to][1] * by[1][lane];
        for (int i = 0; i < 6; i++)
            inputs[tangents[i / 3][to]][i % 3] =
                uv[to][0] * swings[i / 3][0][i % 3] + uv[to][1] * swings[i / 3][1][i % 3];
    }
}
