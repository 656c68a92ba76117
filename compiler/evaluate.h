/* The oracle for a document handle, used to measure programs against it. */
#ifndef MATC_EVALUATE_H
#define MATC_EVALUATE_H
#include "compiler/matc.h"
#include "compiler/oracle/oracle.h"

typedef struct {
    const Surface *at;
    int count;
} SurfacePoints;

/* Evaluates a material's slots at the points in double precision, with the noise and derivatives
 * of the options. The material must exist, and the options must be valid. Images are 0.5 if the
 * document was read without `pixels`. Returns false if a point exceeds LIMIT_WORK, or all points
 * together LIMIT_WORK_POINTS times that; no values are then valid. */
bool evaluate_material(const MatcDocument *document, int material, const MatcOptions *options,
                       SurfacePoints points, SlotValues *values);
/* Returns the fault of a point of matc_eval, in the words of the command line, in the arena;
 * NULL: none. */
const char *evaluate_point_fault(Arena *arena, const char *point);
#endif
