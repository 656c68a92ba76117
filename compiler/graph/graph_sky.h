/* The light that a material of the kind SunSkyLight is. */
#ifndef MATC_GRAPH_SKY_H
#define MATC_GRAPH_SKY_H
#include "compiler/graph/graph.h"

typedef struct {
    double sun[3]; /* the direction to it; unit length, z up */
    double irradiance
        /* by the sun's disc, of a surface that faces it: linear red, green, blue, on the scale of
         * the sky's radiance */
        [3];
    bool light; /* it lights what is under it: not disableLight */
    bool disc;  /* and so does its sun: not disableSun */
} GraphSky;

/* False: the material is none, not through the first choices of switches either. A radianceFactor
 * that is a uniform counts as its default. */
bool graph_sky(const Node *material, GraphSky *sky);
#endif
