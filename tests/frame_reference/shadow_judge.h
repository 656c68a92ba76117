/* Judges whether a pixel is rightly lit by a light or in its shadow: by Embree's ray, and if
 * that disagrees with the picture, by all triangles in double. */
#ifndef MATC_SHADOW_JUDGE_H
#define MATC_SHADOW_JUDGE_H
#include "tests/frame_reference/shadow_ray.h"

typedef struct {
    const Tracer *tracer;
    double reach; /* half of the longest side of the scene's bounding box, without planes */
    double middle[3];
} ShadowJudge;

typedef enum {
    SHADOW_right,
    /* right for a point, or an eye ray, that is moved by 1e-6 of the reach */
    SHADOW_tie,
    /* right for a triangle visible 1/128 of a pixel away, which a rasterizer is free to show */
    SHADOW_seen_tie,
    SHADOW_wrong,
    SHADOW_nothing, /* no surface is visible */
    SHADOW_VERDICTS
} ShadowVerdict;

ShadowJudge shadow_judge(const Tracer *tracer);
/* Judges a position of the picture; a pixel's center is at x + .5, y + .5, y up. */
ShadowVerdict shadow_verdict(const ShadowJudge *judge, const SceneLight *light, const double at[2],
                             bool lit);
#endif
