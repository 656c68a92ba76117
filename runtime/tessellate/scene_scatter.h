/* Placement of copies by a rule and a seed, identical on every machine. */
#ifndef MATC_SCENE_SCATTER_H
#define MATC_SCENE_SCATTER_H
#include "runtime/tessellate/scene_surface.h"
#include <stdint.h>

/* Draws a random number by SplitMix64 (Steele, Lea, Flood 2014): advances the state and returns
 * the next number. The state 0 yields 0xe220a8397b1dcdaf, 0x6e789e6aa1b965f4. */
uint64_t scene_scatter_next(uint64_t *state);

/* Returns the random number of an object in materials: objectRandom in formulas. In [0, 1), in
 * steps of 2^-24: for object 0 .8833, from the generator of Scatter, seeded by the index. */
float scene_object_random(int object);

typedef struct {
    double size[3];              /* size of the box around the origin that contains the copies */
    double rotation[3];          /* maximum angle in radians about x, y and z, in both directions */
    double least, most;          /* range of the copies' scale */
    const SceneSurface *surface; /* copies are on this surface; NULL: in the box */
    bool aligned;                /* rotated to the surface's normal */
} SceneScatter;

/* Sets the three numbers for the position that scene_scatter_matrix() will draw. */
void scene_scatter_numbers(uint64_t state, double numbers[3]);
/* Returns a rotation that maps z to a unit vector. */
SceneMatrix scene_scatter_turn(const double n[3]);
/* Returns the next copy's matrix. Draws seven numbers: for its position (x, y, z, or those of
 * scene_surface_point), its rotations about x, y, z, and its scale. */
SceneMatrix scene_scatter_matrix(const SceneScatter *scatter, uint64_t *state);
#endif
