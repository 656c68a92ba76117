/* Part of the world that a camera and shadows can see: subdivision leaves out the rest. */
#ifndef MATC_SCENE_SIGHT_H
#define MATC_SCENE_SIGHT_H
#include "runtime/scene/scene.h"

/* Half spaces of the world, n x + d >= 0 inside, n of unit length: what is outside of one of them
 * is not seen. */
typedef struct {
    const double (*planes)[4];
    int count;
    /* its lights cast shadows, by maps, and none has an extent; NULL: none does */
    const Scene *casts;
    double low[3],
        /* of a box around all that shadows may fall on, but grounds; low >= high: they fall
         * anywhere */
        high[3];
    /* infinite planes on which they may fall as well, n x + d = 0 with n of unit length */
    const double (*grounds)[4];
    int ground_count;
} SceneSight;

/* No point of the triangle is seen, wherever all are moved to by no more than `bound`, nor does one
 * throw a shadow on what is. A tenth of how far it is away may a camera turn until it is; the
 * lights may not move. Where shadows fall anywhere, and lights cast them, none is sure to be left
 * out. */
bool scene_sight_misses(const SceneSight *sight, const double eye[3], const double corners[3][3],
                        double bound);
#endif
