/* A ball and a torus, and the normals of their displaced surfaces in closed form, for tests of
 * displacement on curved bases. */
#ifndef MATC_VALUE_CURVED_H
#define MATC_VALUE_CURVED_H
#include "compiler/oracle/oracle.h"

/* A ball of radius 1; a torus around the z axis with a tube of radius 0.5 at distance 1. */
typedef enum {
    CURVED_ball,
    CURVED_torus,
    CURVED_COUNT,
    /* the ball with longitudes advanced by 2 v: its tangents are not perpendicular, and both
     * rotate along v */
    CURVED_twisted = CURVED_COUNT
} CurvedBody;
static const double curved_radius[] = {1, 0.5, 1}; /* the smallest radius of curvature */

/* The height at a position (x, y, z), in [-1, 1], for `displacement`. */
#define CURVED_HEIGHT "'= sin(3 * x + 1) * cos(2 * y + z)'"

/* A vector with components in [-1, 1], for `displacementVector`. */
#define CURVED_VECTOR "'= [sin(3 * x + 1) * cos(2 * y + z), cos(2 * x - z + 1), sin(y + 2 * z)]'"

/* The base at (u, v) in [0, 1]: on the ball the longitude from the x axis and the pole-to-pole
 * parameter, on the torus the angles around the axis and around the tube. */
void curved_surface(CurvedBody body, double u, double v, Surface *surface);
/* The unit normal of the base's point nearest to a position. */
void curved_base(CurvedBody body, const double place[3], double normal[3]);
/* The unit normal of the base displaced by scale times the height along its normals, at the
 * base's point nearest to `place`: n - sum of g_i / (1 + h k_i) along both directions of
 * principal curvature, with h the height, g_i its slope and k_i = 1 / radius. `stay`: the base's
 * normals are taken as constant, k_i = 0. Example: a ball of radius 1, h = 0.25 and a slope of
 * 0.1 along x, n = (0, 0, 1): (-0.08, 0, 1) / |...|. */
void curved_normal(CurvedBody body, double scale, const double place[3], bool stay,
                   double normal[3]);
/* Normal of the base displaced by scale times that vector, along the unit tangents and the
 * normal, in the rotating frame: with a around the axis, b across and e, f the unit tangents
 * there, e_a = sin b f - cos b n, f_a = -sin b e, n_a = cos b e, f_b = -n, n_b = f and e_b = 0.
 * For the twisted ball, by finite differences of the displaced surface itself. */
void curved_vector_normal(CurvedBody body, double scale, const double place[3], double normal[3]);
/* Angle between two vectors in degrees. */
double curved_angle(const double a[3], const double b[3]);
#endif
