/* Bisection on the CPU, the reference for bisection by compute stages. */
#ifndef TESTS_BISECTION_REFERENCE_H
#define TESTS_BISECTION_REFERENCE_H
#include "runtime/scene/scene_patches.h"

typedef struct {
    const Scene *scene; /* with a square picture and a mesh of patches as its first object */
    const MatcOptions *options;
    bool closed; /* backs of the mesh are never visible */
} BisectionReference;

/* Leaves as base << 32 | number, unsorted; from malloc. A failure ends the test. */
uint64_t *bisection_reference(const BisectionReference *of, int *count);
#endif
