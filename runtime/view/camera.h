/* Where the preview looks from. */
#ifndef MATC_VIEW_CAMERA_H
#define MATC_VIEW_CAMERA_H
#include "runtime/scene/scene.h"

/* Position of a camera and its target, both in the world, whose z is up. */
typedef struct {
    double position[3], target[3];
    double angle; /* of view, of the picture's shorter side, in radians */
} Viewpoint;

/* The one that shows a shape at its best, filling the picture. */
Viewpoint camera_viewpoint_for(ShapeKind shape);
/* Another one: "front", "left", "top", "low", "close", or numbers "X,Y,Z", "X,Y,Z,X,Y,Z",
 * "X,Y,Z,X,Y,Z,DEGREES": position, target, angle of view. What is not said stays. False: it is none
 * of these, or looks nowhere. */
bool camera_viewpoint_read(const char *text, Viewpoint *viewpoint);

SceneCamera camera_at(const Viewpoint *viewpoint);
/* One that stands at the origin and looks over a low horizon, wide-angled. Azimuth in radians from
 * the x axis. */
SceneCamera camera_for_sky(double azimuth);
#endif
