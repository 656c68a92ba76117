/* Evaluates an Ir at the points that tests shade. */
#ifndef MATC_VALUE_EVALUATE_H
#define MATC_VALUE_EVALUATE_H
#include "compiler/ir/fold.h"
#include "points.h"

enum { EVALUATE_TEXTURES = 64 };

/* The textures of an IR, as the reference functions take them; false: there are more than
 * EVALUATE_TEXTURES. */
bool evaluate_textures(Arena *arena, const Ir *ir, ReferenceTexture textures[EVALUATE_TEXTURES]);
void evaluate_inputs(const Point *point, bool front, double inputs[INPUT_COUNT][4]);
/* Change of a curved surface to the next pixels: texture coordinates and the normal, which has
 * point_bends. */
void evaluate_bends(const Point *point, double inputs[INPUT_COUNT][4]);
#endif
