/* Copies by a rule and a seed: where each stands, the same on every machine. */
#ifndef MATC_SCENE_SCATTER_H
#define MATC_SCENE_SCATTER_H
#include "runtime/tessellate/scene_surface.h"
#include <stdint.h>

/* SplitMix64 (Steele, Lea, Flood 2014): from a state to the next number. From the state 0 come
 * 0xe220a8397b1dcdaf, 0x6e789e6aa1b965f4. */
uint64_t scene_scatter_next(uint64_t *state);

/* The random number that materials know the object of that index by: objectRandom of formulas. In
 * [0, 1), in steps of 2^-24: of object 0 .8833, from the generator of Scatter, seeded by the index.
 */
float scene_object_random(int object);

typedef struct {
    double size[3];              /* of the box around the origin in which they stand */
    double rotation[3];          /* radians about x, y and z, at most, either way */
    double least, most;          /* scale */
    const SceneSurface *surface; /* they stand there; NULL: in the box */
    bool aligned;                /* to its normal */
} SceneScatter;

/* The three numbers of its place that scene_scatter_matrix will draw. */
void scene_scatter_numbers(uint64_t state, double numbers[3]);
/* A turn that takes z to a unit vector. */
SceneMatrix scene_scatter_turn(const double n[3]);
/* The next copy's matrix: seven numbers are drawn, for its place (x, y, z, or those of
 * scene_surface_point), its rotations about x, y, z, and its scale. */
SceneMatrix scene_scatter_matrix(const SceneScatter *scatter, uint64_t *state);
#endif
