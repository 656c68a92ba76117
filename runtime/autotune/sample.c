/* Low-discrepancy points, and a plane in perspective. */
#include "runtime/autotune/sample.h"
#include <string.h>

/* Returns element `index` of a low-discrepancy sequence in [0, 1): multiples of an irrational
 * number per dimension (additive recurrence). */
static double spread(int index, int dimension)
{
    static const double root[] = {0.41421356237309505, 0.7320508075688772, 0.2360679774997898,
                                  0.6457513110645907,  0.3166247903554,    0.605551275463989,
                                  0.1231056256176605,  0.358898943540674,  0.795831523312719,
                                  0.385164807134504,   0.567764362830022};
    return fraction((index + 1) * root[dimension]);
}

static void set3(float to[3], double x, double y, double z)
{
    to[0] = (float)x;
    to[1] = (float)y;
    to[2] = (float)z;
}

/* Sets a normal given by height and angle, and two tangents that complete a right-handed frame. */
static void set_frame(FieldVertex *v, double height, double angle, double turn)
{
    double r = sqrt(fmax(0, 1 - height * height)), s = sin(angle), c = cos(angle), a = cos(turn),
           b = sin(turn);
    const double east[3] = {-s, c, 0}, north[3] = {-height * c, -height * s, r};
    set3(v->input[INPUT_N], r * c, r * s, height);
    for (int i = 0; i < 3; i++) {
        v->input[INPUT_DU][i] = (float)(a * east[i] + b * north[i]);
        v->input[INPUT_DV][i] = (float)(a * north[i] - b * east[i]);
    }
    memcpy(v->input[INPUT_eyeN], v->input[INPUT_N], sizeof v->input[INPUT_N]);
    memcpy(v->input[INPUT_XU], v->input[INPUT_DU], sizeof v->input[INPUT_DU]);
    memcpy(v->input[INPUT_XV], v->input[INPUT_DV], sizeof v->input[INPUT_DV]);
    set3(v->input[INPUT_ray], -r * c, -r * s, -height);
}

void sample_points(FieldVertex points[POINTS], double range)
{
    memset(points, 0, POINTS * sizeof *points);
    for (int i = 0; i < POINTS; i++) {
        FieldVertex *v = &points[i];
        double position[8];
        for (int k = 0; k < 8; k++)
            position[k] = range * (2 * spread(i, k) - 1);
        v->at[0] = (float)(2 * (i % POINTS_WIDTH + 0.5) / POINTS_WIDTH - 1);
        v->at[1] = (float)(2 * (i / POINTS_WIDTH + 0.5) / POINTS_HEIGHT - 1);
        v->at[3] = 1;
        set3(v->input[INPUT_P], position[0], position[1], position[2]);
        set3(v->input[INPUT_X], position[3], position[4], position[5]);
        set3(v->input[INPUT_U], position[6], position[7], 0);
        set_frame(v, 2 * spread(i, 8) - 1, 2 * M_PI * spread(i, 9), 2 * M_PI * spread(i, 10));
    }
}

void sample_surface(const FieldVertex *point, Surface *surface)
{
    static const Input input[] = {[GROUP_P] = INPUT_P,   [GROUP_N] = INPUT_N, [GROUP_DU] = INPUT_DU,
                                  [GROUP_DV] = INPUT_DV, [GROUP_U] = INPUT_U, [GROUP_X] = INPUT_X};
    oracle_surface_default(surface);
    for (Group group = 0; group < GROUP_R; group++)
        for (int component = 0; component < type_table[input_table[input[group]].type].components;
             component++)
            surface->root[channel_id(group, component)] = point->input[input[group]][component];
    for (int component = 0; component < 3; component++) {
        surface->local_u[component] = point->input[INPUT_XU][component];
        surface->local_v[component] = point->input[INPUT_XV][component];
    }
}

/* Sets the vertex at corner (x, y) of the picture to the intersection of its view ray with the
 * plane. The clip coordinate w is the depth, so interpolation is perspective-correct. */
static void set_corner(FieldVertex *v, const PlaneView *view, double x, double y, double pitch)
{
    const double half = 0.5; /* tangent of half the vertical field of view */
    double c = cos(view->yaw), s = sin(view->yaw), right = x * half * view->aspect;
    double forward = cos(pitch) + y * half * sin(pitch), up = -sin(pitch) + y * half * cos(pitch),
           depth = -1 / up;
    double px = depth * (forward * c + right * s), py = depth * (forward * s - right * c);
    memset(v, 0, sizeof *v);
    v->at[0] = (float)(x * depth);
    v->at[1] = (float)(y * depth);
    v->at[3] = (float)depth;
    set3(v->input[INPUT_P], px + view->shift[0], py + view->shift[1], 0);
    set3(v->input[INPUT_X], px + view->shift[0], py + view->shift[1], 0);
    set3(v->input[INPUT_U], view->scale * (px + view->shift[0]),
         view->scale * (py + view->shift[1]), 0);
    set3(v->input[INPUT_N], 0, 0, 1);
    set3(v->input[INPUT_eyeN], 0, 0, 1);
    set3(v->input[INPUT_DU], 1 / view->scale, 0, 0);
    set3(v->input[INPUT_DV], 0, 1 / view->scale, 0);
    set3(v->input[INPUT_XU], 1 / view->scale, 0, 0);
    set3(v->input[INPUT_XV], 0, 1 / view->scale, 0);
    set3(v->input[INPUT_ray], px, py, -1);
}

void sample_plane(FieldVertex vertices[PLANE_VERTICES], const PlaneView *view)
{
    /* A tenth of a pixel, so that the horizon itself is not drawn. */
    const double beyond = 0.1 * 2 / view->height;
    double pitch = atan(0.5 * (1 + beyond));
    for (int i = 0; i < PLANE_VERTICES; i++)
        set_corner(&vertices[i], view, i % 2 ? 1.2 : -1.2, i < 2 ? -1.2 : 1 + beyond / 2, pitch);
}
