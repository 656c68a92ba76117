/* Part of the world that a camera and shadows can see: subdivision leaves out the rest. */
#ifndef MATC_SCENE_SIGHT_H
#define MATC_SCENE_SIGHT_H
#include "runtime/scene/scene.h"

/* The view as half spaces in world space, n x + d >= 0 inside, n of unit length: points outside
 * of any of them are invisible. */
typedef struct {
    const double (*planes)[4];
    int count;
    /* The scene, if its lights cast shadows by maps and none is an area light; NULL: no shadows. */
    const Scene *casts;
    /* Box around everything on which shadows may fall, except grounds; low >= high: no
     * limit. */
    double low[3], high[3];
    /* Infinite planes on which shadows may fall, too: n x + d = 0 with n of unit length. */
    const double (*grounds)[4];
    int ground_count;
} SceneFrustums;

/* Reports whether no point of the triangle is visible, for any displacement by at most `bound`,
 * nor casts a shadow on a visible point. The camera may turn by a tenth of the triangle's
 * distance until the result is invalid; the lights may not move. If shadows are not limited to a
 * box, and lights cast them, no triangle is safely left out. */
bool scene_sight_misses(const SceneFrustums *sight, const double eye[3], const double corners[3][3],
                        double bound);
#endif
