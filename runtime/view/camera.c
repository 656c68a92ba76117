/* A shape and a picture's size in, the camera's matrices out. */
#include "camera.h"
#include <math.h>

#define RADIANS (3.14159265358979323846 / 180)

/* Degrees; azimuth from the x axis. The sphere is seen from where its seam, at the x axis, hides behind the rim. */
static const struct {
    double azimuth, elevation;
    double distance; /* from the origin, such that the shape fills the frame */
    double shift;    /* of the target along z, to centre the shape's outline */
} places[SHAPE_count] = {
    [SHAPE_sphere] = {-112, 22, 4.55, 0},
    [SHAPE_plane] = {-90, 60, 4.75, -0.06},
    [SHAPE_cube] = {-118, 27, 6.9, -0.04},
    [SHAPE_torus] = {-112, 40, 4.5, -0.02},
};

#define HALF_ANGLE (15 * RADIANS)

Camera camera_for(ShapeKind shape, int width, int height)
{
    double a = places[shape].azimuth * RADIANS, e = places[shape].elevation * RADIANS, d = places[shape].distance;
    double aspect = (double)width / height;
    double tangent = tan(HALF_ANGLE) / (aspect < 1 ? aspect : 1); /* the shorter side holds the shape */
    const float target[3] = {0, 0, (float)places[shape].shift}, up[3] = {0, 0, 1};
    Camera camera = {.position = {(float)(d * cos(a) * cos(e)), (float)(d * sin(a) * cos(e)), (float)(d * sin(e))}};
    camera.eye_from_world = mat4_look_at(camera.position, target, up);
    camera.clip_from_eye = mat4_perspective((float)tangent, (float)aspect, (float)(d - 2), (float)(d + 2));
    camera.clip_from_world = mat4_multiply(&camera.clip_from_eye, &camera.eye_from_world);
    mat4_inverse(&camera.clip_from_eye, &camera.eye_from_clip); /* never singular */
    return camera;
}
