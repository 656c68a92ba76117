/* A ball and a torus, and the normals of their displaced surfaces in closed form, for tests of
 * displacement on curved bases. */
#ifndef MATC_VALUE_CURVED_H
#define MATC_VALUE_CURVED_H
#include "compiler/oracle/oracle.h"

/* A ball of radius 1; a torus around the z axis whose tube of radius 0.5 has its middle 1 away. */
typedef enum {
    CURVED_ball,
    CURVED_torus,
    CURVED_COUNT,
    /* the ball, whose longitudes are 2 v further on: tangents stand at no right angles, and both
     * turn along v */
    CURVED_twisted = CURVED_COUNT
} CurvedBody;
static const double curved_radius[] = {1, 0.5, 1}; /* the smaller of curvature */

/* The height of a place (x, y, z), at most 1 either way, as `displacement` has it. */
#define CURVED_HEIGHT "'= sin(3 * x + 1) * cos(2 * y + z)'"

/* A vector, each of its components at most 1 either way, as `displacementVector` has it. */
#define CURVED_VECTOR "'= [sin(3 * x + 1) * cos(2 * y + z), cos(2 * x - z + 1), sin(y + 2 * z)]'"

/* The base at (u, v), each from 0 to 1: of the ball the longitude from the x axis and the way from
 * pole to pole, of the torus the angles around the axis and around the tube. */
void curved_surface(CurvedBody body, double u, double v, Surface *surface);
/* The unit normal of the base where it is nearest to a place. */
void curved_base(CurvedBody body, const double place[3], double normal[3]);
/* The unit normal of the base raised by scale times the height along its normals, above the point
 * of the base that is nearest to `place`: n - sum of g_i / (1 + h k_i) along both directions in
 * which the surface bends, with h the height, g_i its slope and k_i = 1 / radius. `stay`: normals
 * of the base are taken to stay as they are, k_i = 0. A ball of radius 1, h = 0.25 and a slope of
 * 0.1 along x, n = (0, 0, 1): (-0.08, 0, 1) / |...|. */
void curved_normal(CurvedBody body, double scale, const double place[3], bool stay,
                   double normal[3]);
/* Normal of the base moved by scale times that vector, along the unit tangents and the normal, in
 * the frame that rotates along: with a around the axis, b across and e, f the unit tangents there,
 * e_a = sin b f - cos b n, f_a = -sin b e, n_a = cos b e, f_b = -n, n_b = f and e_b = 0. For a
 * twisted body, by differences of the moved surface itself. */
void curved_vector_normal(CurvedBody body, double scale, const double place[3], double normal[3]);
/* Degrees between two vectors. */
double curved_angle(const double a[3], const double b[3]);
#endif
