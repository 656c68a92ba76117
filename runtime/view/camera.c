/* A shape, or a viewpoint that somebody names, and a picture's size in; the camera's matrices out. */
#include "runtime/view/camera.h"
#include "compiler/base/text.h"
#include <math.h>
#include <string.h>

#define RADIANS (3.14159265358979323846 / 180)

/* Degrees; azimuth from the x axis. The sphere is seen from where its seam, at the x axis, hides behind the rim. */
static const struct {
    double azimuth, elevation;
    double distance; /* from the origin, such that the shape fills the frame */
    double shift;    /* of the target along z, to centre the shape's outline */
    double angle;    /* of view */
    double reach;    /* the shape lies within */
} viewpoints[SHAPE_count] = {
    [SHAPE_sphere] = {-112, 22, 4.55, 0, 30, 2},  [SHAPE_plane] = {-90, 60, 4.75, -0.06, 30, 2},
    [SHAPE_cube] = {-118, 27, 6.9, -0.04, 30, 2}, [SHAPE_torus] = {-112, 40, 4.5, -0.02, 30, 2},
    [SHAPE_cloth] = {-105, 12, 4.9, 0, 30, 2},    [SHAPE_ground] = {-90, 14, 4, 0.45, 50, 2 * SHAPE_HORIZON},
};

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

static double length_of(const double v[3]) { return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

/* At a distance from the origin, in a direction. */
static void stand(Viewpoint *viewpoint, double azimuth, double elevation, double distance)
{
    double a = azimuth * RADIANS, e = elevation * RADIANS;
    viewpoint->position[0] = distance * cos(a) * cos(e);
    viewpoint->position[1] = distance * sin(a) * cos(e);
    viewpoint->position[2] = distance * sin(e);
}

Viewpoint camera_viewpoint_for(ShapeKind shape)
{
    Viewpoint viewpoint = {.target = {0, 0, viewpoints[shape].shift},
                           .angle = viewpoints[shape].angle * RADIANS,
                           .reach = viewpoints[shape].reach};
    stand(&viewpoint, viewpoints[shape].azimuth, viewpoints[shape].elevation, viewpoints[shape].distance);
    return viewpoint;
}

static const struct {
    const char *name;
    double azimuth, elevation;
    double nearer; /* the distance is multiplied by it */
} presets[] = {
    {"front", -90, 5, 1}, {"left", -180, 5, 1}, {"top", -90, 89, 1}, {"low", -112, 6, 1}, {"close", -112, 22, 0.45},
};

/* Up to `most` numbers with commas between them; their count, 0: it is something else. */
static int read_numbers(const char *text, double *numbers, int most)
{
    for (int count = 0; count < most; count++) {
        const size_t size = strcspn(text, ",");
        if (!text_number(text, size, &numbers[count]) || !isfinite(numbers[count]))
            return 0;
        if (!text[size])
            return count + 1;
        text += size + 1;
    }
    return 0;
}

/* It stands where it looks, or looks along the axis that is up, or sees nothing or everything. */
static bool is_blind(const Viewpoint *p)
{
    const double d[3] = {p->target[0] - p->position[0], p->target[1] - p->position[1], p->target[2] - p->position[2]};
    return hypot(d[0], d[1]) <= 1e-4 * fabs(d[2]) || length_of(d) < 1e-4 || length_of(p->position) > 1e4 ||
           p->angle < 0.5 * RADIANS || p->angle > 150 * RADIANS;
}

bool camera_viewpoint_read(const char *text, Viewpoint *viewpoint)
{
    enum { MOST = 7 };
    double numbers[MOST];
    Viewpoint read = *viewpoint;
    for (size_t i = 0; i < sizeof presets / sizeof *presets; i++) {
        if (strcmp(presets[i].name, text) != 0)
            continue;
        stand(viewpoint, presets[i].azimuth, presets[i].elevation, presets[i].nearer * length_of(viewpoint->position));
        return true;
    }
    int count = read_numbers(text, numbers, MOST);
    if (count != 3 && count < 6)
        return false;
    memcpy(read.position, numbers, sizeof read.position);
    if (count >= 6)
        memcpy(read.target, numbers + 3, sizeof read.target);
    if (count == MOST)
        read.angle = numbers[6] * RADIANS;
    if (is_blind(&read))
        return false;
    *viewpoint = read;
    return true;
}

Camera camera_at(const Viewpoint *viewpoint, int width, int height)
{
    double aspect = (double)width / height, distance = length_of(viewpoint->position);
    float target[3];
    Camera camera = {0};
    for (int i = 0; i < 3; i++) {
        camera.position[i] = (float)viewpoint->position[i];
        target[i] = (float)viewpoint->target[i];
    }
    float near = (float)fmax(distance - viewpoint->reach, 0.02), far = (float)(distance + viewpoint->reach);
    Mat4 clip = mat4_perspective(height_of(tan(viewpoint->angle / 2), aspect), (float)aspect, near, far);
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
