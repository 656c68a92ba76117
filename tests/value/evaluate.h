/* Evaluates an Ir at the points that tests shade. */
#ifndef MATC_VALUE_EVALUATE_H
#define MATC_VALUE_EVALUATE_H
#include "compiler/ir/fold.h"
#include "points.h"

enum { EVALUATE_TEXTURES = 64 };

/* Converts the textures of an IR to those of the reference functions; false if there are more
 * than EVALUATE_TEXTURES. */
bool evaluate_textures(Arena *arena, const Ir *ir, ReferenceTexture textures[EVALUATE_TEXTURES]);
void evaluate_inputs(const Point *point, bool front, double inputs[INPUT_COUNT][4]);
/* Changes of inputs to the next pixels on a curved surface: texture coordinates, and the normal
 * by point_bends. */
void evaluate_bends(const Point *point, double inputs[INPUT_COUNT][4]);
#endif
