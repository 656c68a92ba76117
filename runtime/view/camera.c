/* A shape and a picture's size in, the camera's matrices out. */
#include "runtime/view/camera.h"
#include <math.h>

#define RADIANS (3.14159265358979323846 / 180)

/* Degrees; azimuth from the x axis. The sphere is seen from where its seam, at the x axis, hides behind the rim. */
static const struct {
    double azimuth, elevation;
    double distance; /* from the origin, such that the shape fills the frame */
    double shift;    /* of the target along z, to centre the shape's outline */
} viewpoints[SHAPE_count] = {
    [SHAPE_sphere] = {-112, 22, 4.55, 0},
    [SHAPE_plane] = {-90, 60, 4.75, -0.06},
    [SHAPE_cube] = {-118, 27, 6.9, -0.04},
    [SHAPE_torus] = {-112, 40, 4.5, -0.02},
};

#define HALF_ANGLE     (15 * RADIANS)
#define SKY_HALF_ANGLE (45 * RADIANS)
#define SKY_ELEVATION  (41 * RADIANS) /* the horizon stays in sight */

static void complete(Camera *camera, const float target[3], const Mat4 *clip_from_eye)
{
    const float up[3] = {0, 0, 1};
    camera->eye_from_world = mat4_look_at(camera->position, target, up);
    camera->clip_from_eye = *clip_from_eye;
    mat4_inverse(&camera->clip_from_eye, &camera->eye_from_clip); /* never singular */
}

/* Tangent of half the vertical angle, when half that of the shorter side has this one. */
static float height_of(double tangent, double aspect) { return (float)(tangent / (aspect < 1 ? aspect : 1)); }

Camera camera_for(ShapeKind shape, int width, int height)
{
    double a = viewpoints[shape].azimuth * RADIANS, e = viewpoints[shape].elevation * RADIANS,
           d = viewpoints[shape].distance;
    double aspect = (double)width / height;
    const float target[3] = {0, 0, (float)viewpoints[shape].shift};
    Camera camera = {.position = {(float)(d * cos(a) * cos(e)), (float)(d * sin(a) * cos(e)), (float)(d * sin(e))}};
    Mat4 clip = mat4_perspective(height_of(tan(HALF_ANGLE), aspect), (float)aspect, (float)(d - 2), (float)(d + 2));
    complete(&camera, target, &clip);
    return camera;
}

Camera camera_for_sky(double azimuth, int width, int height)
{
    double aspect = (double)width / height;
    const float target[3] = {(float)(cos(azimuth) * cos(SKY_ELEVATION)), (float)(sin(azimuth) * cos(SKY_ELEVATION)),
                             (float)sin(SKY_ELEVATION)};
    Camera camera = {0};
    Mat4 clip = mat4_perspective(height_of(tan(SKY_HALF_ANGLE), aspect), (float)aspect, 0.5f, 2);
    complete(&camera, target, &clip);
    return camera;
}
