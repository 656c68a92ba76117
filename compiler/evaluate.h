/* The oracle by a document's handle, for who measures programs against it. */
#ifndef MATC_EVALUATE_H
#define MATC_EVALUATE_H
#include "compiler/matc.h"
#include "compiler/oracle/oracle.h"

typedef struct {
    const Surface *at;
    int count;
} SurfacePoints;

/* The slots of a material at those points, in double, as the options compute them (their noise and
 * derivatives). The material exists, and the options name what exists. Pictures are 0.5 where the
 * document was read without `pixels`. False: one takes more than LIMIT_WORK, or all together
 * LIMIT_WORK_POINTS times that; then none is known. */
bool evaluate_material(const MatcDocument *document, int material, const MatcOptions *options,
                       SurfacePoints points, SlotValues *values);
/* Fault of a point as matc_eval takes it, in the words of the command line, in the arena; NULL:
 * none. */
const char *evaluate_point_fault(Arena *arena, const char *point);
#endif
