/* Converts a shape or a named viewpoint to the scene's camera. */
#include "runtime/viewer/camera.h"
#include "compiler/base/text.h"
#include "compiler/base/vec3.h"
#include <math.h>
#include <string.h>

#define RADIANS (3.14159265358979323846 / 180)

/* Default viewpoints, in degrees; azimuth from the x axis. The sphere's seam at the x axis is
 * hidden behind the silhouette. */
static const struct {
    double azimuth, elevation;
    double distance; /* distance from the origin, chosen to make the shape fill the frame */
    double shift;    /* shift of the target along z, to center the shape's outline */
    double angle;    /* angle of view */
} viewpoints[SHAPE_count] = {
    [SHAPE_sphere] = {-112, 22, 4.55, 0, 30},  [SHAPE_plane] = {-90, 60, 4.75, -0.06, 30},
    [SHAPE_cube] = {-118, 27, 6.9, -0.04, 30}, [SHAPE_torus] = {-112, 40, 4.5, -0.02, 30},
    [SHAPE_cloth] = {-105, 12, 4.9, 0, 30},    [SHAPE_ground] = {-90, 14, 4, 0.45, 50},
};

#define SKY_ANGLE     (90 * RADIANS)
#define SKY_ELEVATION (41 * RADIANS) /* keeps the horizon in view */
#define NEAREST       0.01

/* Places the viewpoint in a direction (degrees) and at a distance from the origin. */
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
                           .angle = viewpoints[shape].angle * RADIANS};
    stand(&viewpoint, viewpoints[shape].azimuth, viewpoints[shape].elevation,
          viewpoints[shape].distance);
    return viewpoint;
}

static const struct {
    const char *name;
    double azimuth, elevation;
    double nearer; /* factor of the distance */
} presets[] = {
    {"front", -90, 5, 1}, {"left", -180, 5, 1},      {"top", -90, 89, 1},
    {"low", -112, 6, 1},  {"close", -112, 22, 0.45},
};

/* Parses up to `most` comma-separated numbers. Returns their count, or 0 on a syntax error. */
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

/* Returns whether the viewpoint is unusable: position equals target, view direction along the up
 * axis, position too far away, or an extreme angle of view. */
static bool is_blind(const Viewpoint *p)
{
    const double d[3] = {p->target[0] - p->position[0], p->target[1] - p->position[1],
                         p->target[2] - p->position[2]};
    return hypot(d[0], d[1]) <= 1e-4 * fabs(d[2]) || vec3_length(d) < 1e-4 ||
           vec3_length(p->position) > 1e4 || p->angle < 0.5 * RADIANS || p->angle > 150 * RADIANS;
}

bool camera_viewpoint_read(const char *text, Viewpoint *viewpoint)
{
    enum { MOST = 7 };
    double numbers[MOST];
    Viewpoint read = *viewpoint;
    for (size_t i = 0; i < sizeof presets / sizeof *presets; i++) {
        if (strcmp(presets[i].name, text) != 0)
            continue;
        stand(viewpoint, presets[i].azimuth, presets[i].elevation,
              presets[i].nearer * vec3_length(viewpoint->position));
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

static SceneCamera camera_of(const double position[3], const double target[3], double angle)
{
    SceneCamera camera = {
        .kind = SCENE_Perspective, .upright = {0, 0, 1}, .half = tan(angle / 2), .near = NEAREST};
    memcpy(camera.position, position, sizeof camera.position);
    memcpy(camera.target, target, sizeof camera.target);
    scene_camera_aim(&camera); /* viewpoints never look straight up or down */
    return camera;
}

SceneCamera camera_at(const Viewpoint *viewpoint)
{
    return camera_of(viewpoint->position, viewpoint->target, viewpoint->angle);
}

SceneCamera camera_for_sky(double azimuth)
{
    static const double position[3];
    const double target[3] = {cos(azimuth) * cos(SKY_ELEVATION), sin(azimuth) * cos(SKY_ELEVATION),
                              sin(SKY_ELEVATION)};
    return camera_of(position, target, SKY_ANGLE);
}
