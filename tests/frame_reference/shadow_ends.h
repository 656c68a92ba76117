/* Error of shadow boundaries against Embree's rays, on four receivers: casters of one mesh in
 * sunlight, with shadow maps of 256 x 256. */
#ifndef MATC_SHADOW_ENDS_H
#define MATC_SHADOW_ENDS_H
#include "tests/frame/shadow_pair.h"

typedef enum {
    SHADOW_ENDS_plane,
    SHADOW_ENDS_itself,
    SHADOW_ENDS_second,      /* a smooth ball behind the caster */
    SHADOW_ENDS_overlapping, /* the plane, behind two casters that overlap as seen from the light */
    SHADOW_ENDS_RECEIVERS
} ShadowEndsReceiver;
extern const char *const shadow_ends_receivers[SHADOW_ENDS_RECEIVERS];

typedef struct {
    const Shape *mesh;  /* at most 1 from the origin */
    const char *method; /* a method of the list Shadows */
    ShadowEndsReceiver receiver;
    /* include points whose geometric and shading normal are on different sides of the light */
    bool all;
    Keyword volume; /* volume of hybrid shadows, of the list Volume; 0: another method */
    int pixels;     /* width of the picture; 0: 320, at most about two pixels per texel's edge */
} ShadowEnds;

/* Mean distance of shadow boundaries from the true ones, in texels: the area of wrongly lit and
 * wrongly dark points over the length of the true boundaries. */
double shadow_ends_distance(const ShadowPair *pair, const ShadowEnds *ends);
#endif
