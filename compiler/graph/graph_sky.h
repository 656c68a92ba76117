/* The light of a SunSkyLight material. */
#ifndef MATC_GRAPH_SKY_H
#define MATC_GRAPH_SKY_H
#include "compiler/graph/graph.h"

typedef struct {
    double sun[3]; /* direction to the sun; unit length, z up */
    double irradiance
        /* Irradiance by the sun's disc of a surface that faces it: linear red, green, blue, on
         * the scale of the sky's radiance. */
        [3];
    bool light; /* the sky lights the scene: not disableLight */
    bool disc;  /* the sun lights the scene: not disableSun */
} GraphSky;

/* Evaluates a material's sky. Returns false if the material is no SunSkyLight, even through the
 * first choices of switches. A radianceFactor that is a uniform counts as its default. */
bool graph_sky(const Node *material, GraphSky *sky);
#endif
