/* Distance of shadow boundaries from the true ones, in texels of the default map. */
#ifndef SHADOWS_ERROR_H
#define SHADOWS_ERROR_H
#include "shadows_scene.h"

/* Exact shadows, the reference, which tests compare with rays. */
extern const ShadowsMethod shadows_truth;

typedef struct {
    GlContext *gl;
    const MatcOptions *compile;
    int edge, map_size; /* picture size in pixels; map size in texels */
} ShadowsTarget;

/* A picture with each pixel's position in the shadow map, and its true light by exact shadows. */
typedef struct {
    ShadowsTarget target;
    Scene *scene;
    double (*places)[2]; /* in texels */
    /* light without shadows; 0 in the background, and on faces away from the light */
    float *light;
    float *truth;  /* true shares of the light: 0 or 1 */
    double length; /* length of the shadow boundary, in texels */
} ShadowsPicture;

/* Returns false after a message on standard error. */
bool shadows_picture_open(const ShadowsTarget *target, const ShadowsPlace *place,
                          ShadowsPicture *made);
/* The mean distance of shadow boundaries from the true ones: the area of wrongly lit and wrongly
 * dark points over the true boundary's length. Also the ratio of both lengths: stairs are longer
 * than the line they follow. A point that receives at least half of the light is lit. */
typedef struct {
    double distance, length;
} ShadowsError;
/* Error with a shadow map of map_size texels. Returns false after a message on standard error. */
bool shadows_picture_error(const ShadowsPicture *picture, const ShadowsMethod *method, int map_size,
                           ShadowsError *error);
void shadows_picture_close(ShadowsPicture *picture);
#endif
