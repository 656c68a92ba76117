/* Distance of shadow boundaries from the true ones, in texels of the default map. */
#ifndef SHADOWS_ERROR_H
#define SHADOWS_ERROR_H
#include "shadows_scene.h"

/* Exact shadows, which tests compare with rays. */
extern const ShadowsMethod shadows_truth;

typedef struct {
    GlContext *gl;
    const MatcOptions *compile;
    int edge, map_size; /* of pictures, in pixels; of maps, in texels */
} ShadowsTarget;

/* A picture of which each pixel knows its place in the map, and whether light arrives there: by
 * exact shadows. */
typedef struct {
    ShadowsTarget target;
    Scene *scene;
    double (*places)[2]; /* texels */
    /* without shadows; 0 where nothing is, or what faces away from the light */
    float *light;
    float *truth;  /* shares of that: 0 or 1 */
    double length; /* of the boundary between them, in texels */
} ShadowsPicture;

/* False: said on standard error. */
bool shadows_picture_open(const ShadowsTarget *target, const ShadowsPlace *place,
                          ShadowsPicture *made);
/* The mean distance of ends from the true ones: the area of points that are lit and should not be,
 * or the other way round, over the true end's length. And how long they are, over that: stairs are
 * longer than the line they follow. A point to which half of the light comes, or more, is lit. */
typedef struct {
    double distance, length;
} ShadowsError;
/* By a map of so many texels. False: said on standard error. */
bool shadows_picture_error(const ShadowsPicture *picture, const ShadowsMethod *method, int map_size,
                           ShadowsError *error);
void shadows_picture_close(ShadowsPicture *picture);
#endif
