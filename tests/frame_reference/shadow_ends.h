/* Error of shadow boundaries against Embree's rays, on four receivers: casters of one mesh in
 * sunlight, with shadow maps of 256 x 256. */
#ifndef MATC_SHADOW_ENDS_H
#define MATC_SHADOW_ENDS_H
#include "tests/frame/shadow_pair.h"

typedef enum {
    SHADOW_ENDS_plane,
    SHADOW_ENDS_itself,
    SHADOW_ENDS_second,      /* a smooth ball behind the caster */
    SHADOW_ENDS_overlapping, /* the plane, behind two casters that overlap as the light sees them */
    SHADOW_ENDS_RECEIVERS
} ShadowEndsReceiver;
extern const char *const shadow_ends_receivers[SHADOW_ENDS_RECEIVERS];

typedef struct {
    const Shape *mesh;  /* at most 1 from the origin */
    const char *method; /* of the list Shadows */
    ShadowEndsReceiver receiver;
    /* also points where the facet and the normal are on different sides of the light */
    bool all;
    Keyword volume; /* of hybrid shadows, of the list Volume; 0: it is another method */
    int pixels;     /* the picture's edge; 0: 320, some two for each texel's edge, or less */
} ShadowEnds;

/* The area of points that are lit and should not be, or the other way round, over the length of the
 * true ends: in texels. */
double shadow_ends_distance(const ShadowPair *pair, const ShadowEnds *ends);
#endif
