/* Bisection on the CPU, the reference for bisection by compute stages. */
#ifndef TESTS_BISECTION_REFERENCE_H
#define TESTS_BISECTION_REFERENCE_H
#include "runtime/scene/scene_patches.h"

typedef struct {
    const Scene *scene; /* of a square picture, whose first object is a mesh of patches */
    const MatcOptions *options;
    bool closed; /* nobody sees the mesh from behind */
} BisectionReference;

/* Leaves as base << 32 | number, in no order; from malloc. What fails ends the test. */
uint64_t *bisection_reference(const BisectionReference *of, int *count);
#endif
