/* Judges whether a pixel is rightly lit by a light or in its shadow: by Embree's ray, and if
 * that disagrees with the picture, by all triangles in double. */
#ifndef MATC_SHADOW_JUDGE_H
#define MATC_SHADOW_JUDGE_H
#include "tests/frame_reference/shadow_ray.h"

typedef struct {
    const Tracer *tracer;
    double reach; /* half of the longest side of what the scene fills, but for planes */
    double middle[3];
} ShadowJudge;

typedef enum {
    SHADOW_right,
    /* it would be right for a point, or a ray from the eye, that is 1e-6 of the reach away */
    SHADOW_tie,
    /* it is right for a triangle that is seen 1/128 of a pixel away: a rasteriser is free to show
     * that */
    SHADOW_seen_tie,
    SHADOW_wrong,
    SHADOW_nothing, /* is seen there */
    SHADOW_VERDICTS
} ShadowVerdict;

ShadowJudge shadow_judge(const Tracer *tracer);
/* At a place of the picture; a pixel's middle is at x + .5, y + .5, y up. */
ShadowVerdict shadow_verdict(const ShadowJudge *judge, const SceneLight *light, const double at[2],
                             bool lit);
#endif
