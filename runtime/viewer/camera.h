/* Cameras of material previews: default viewpoints, named viewpoints and the sky camera. */
#ifndef MATC_VIEWER_CAMERA_H
#define MATC_VIEWER_CAMERA_H
#include "runtime/scene/scene.h"

/* Position and target of a camera in world space (z up). */
typedef struct {
    double position[3], target[3];
    double angle; /* angle of view across the picture's shorter side, in radians */
} Viewpoint;

/* Returns the default camera: a three-quarter view that fits the shape into the picture. */
Viewpoint camera_viewpoint_for(ShapeKind shape);
/* Parses a viewpoint: "front", "left", "top", "low", "close", or the numbers "X,Y,Z",
 * "X,Y,Z,X,Y,Z", "X,Y,Z,X,Y,Z,DEGREES" (position, target, angle of view). Values that the text
 * omits keep the values of *viewpoint. Returns false for any other text and for a degenerate
 * view direction. */
bool camera_viewpoint_read(const char *text, Viewpoint *viewpoint);

SceneCamera camera_at(const Viewpoint *viewpoint);
/* Builds the wide-angle camera of the sky pass: at the origin, with a low horizon. `azimuth` is
 * in radians from the x axis. */
SceneCamera camera_for_sky(double azimuth);
#endif
