/* Provides textures and inputs for ir_eval. */
#include "evaluate.h"
#include "compiler/library/carpenter.h"
#include <string.h>

static const float *bake(Arena *arena, const IrTexture *t)
{
    double n[4];
    float *floats = arena_alloc(arena, sizeof *floats * (size_t)t->width * (size_t)t->height);
    for (int k = 0; k < 4; k++) {
        double components[4];
        value_number(&t->node->params[1 + k], TYPE_float, components);
        n[k] = components[0];
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
        textures[i] = (ReferenceTexture){.width = t->width, .height = t->height, .components = 1};
        if (t->kind == TEXTURE_image) {
            textures[i].components = 4;
            textures[i].bytes = image_bytes(t->image);
            textures[i].words = image_words(t->image);
            textures[i].floats = image_floats(t->image);
            textures[i].srgb = t->srgb;
            textures[i].wrap = (ReferenceWrap)(t->wrap - KEYWORD_Address_repeat);
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
        for (int component = 0; component < 3; component++)
            inputs[i][component] = point->input[i][component];
    inputs[INPUT_front][0] = front;
    inputs[INPUT_IOR][0] = point_ior;
    inputs[INPUT_time][0] = point_time;
    memcpy(inputs[INPUT_viewer], point_viewer, sizeof point_viewer);
}

void evaluate_bends(const Point *point, double inputs[INPUT_COUNT][4])
{
    static const Input texture[2] = {INPUT_UX, INPUT_UY}, normal[2] = {INPUT_NX, INPUT_NY};
    /* change to the right neighbor, to the upper one */
    static const double uv[2][2] = {{0.5, 0}, {0.125, -0.25}};
    static const Input tangents[2][2] = {{INPUT_DUX, INPUT_DUY}, {INPUT_DVX, INPUT_DVY}};
    double by[2][3], swings[2][2][3];
    point_bends(point, by[0], by[1]);
    point_swings(point, swings);
    for (int to = 0; to < 2; to++) {
        memcpy(inputs[texture[to]], uv[to], sizeof uv[to]);
        for (int component = 0; component < 3; component++)
            inputs[normal[to]][component] =
                uv[to][0] * by[0][component] + uv[to][1] * by[1][component];
        for (int i = 0; i < 6; i++)
            inputs[tangents[i / 3][to]][i % 3] =
                uv[to][0] * swings[i / 3][0][i % 3] + uv[to][1] * swings[i / 3][1][i % 3];
    }
}
