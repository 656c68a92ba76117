/* Where the preview looks from. */
#ifndef MATC_VIEW_CAMERA_H
#define MATC_VIEW_CAMERA_H
#include "runtime/gl/matrix.h"
#include "runtime/gl/shape.h"

typedef struct {
    float position[3]; /* in the world */
    Mat4 eye_from_world;
    Mat4 clip_from_eye;
    Mat4 eye_from_clip;
} Camera;

/* The camera that shows a shape at its best, filling a picture of this size. */
Camera camera_for(ShapeKind shape, int width, int height);

/* One that stands at the origin and looks over a low horizon, wide-angled. Azimuth in radians from the x axis. */
Camera camera_for_sky(double azimuth, int width, int height);
#endif
