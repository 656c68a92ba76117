/* Small matrices as GL takes them: floats by columns, m[4 * column + row]. */
#ifndef MATC_GL_MATRIX_H
#define MATC_GL_MATRIX_H
#include <stdbool.h>

typedef struct {
    float m[16];
} Mat4;
typedef struct {
    float m[9];
} Mat3;

Mat4 mat4_identity(void);
Mat4 mat4_multiply(const Mat4 *a, const Mat4 *b); /* a b: b is applied first */

/* `height`: the tangent of half the vertical angle; `aspect`: width over height; near and far are
 * positive distances. */
Mat4 mat4_perspective(float height, float aspect, float near, float far);

/* World to eye: the eye looks along -z, y is up as far as it can be. `up` must not be parallel to
 * the direction. */
Mat4 mat4_look_at(const float eye[3], const float target[3], const float up[3]);

/* False for a singular matrix, *inverse stays as it was. */
bool mat4_inverse(const Mat4 *a, Mat4 *inverse);

Mat3 mat3_from_mat4(const Mat4 *a); /* the upper left part */
Mat3 mat3_multiply(const Mat3 *a, const Mat3 *b);

/* Normal matrix of `a`: the inverse transpose of its upper left part, up to a positive factor, so
 * that a singular matrix is no fault. Results are not of unit length. */
Mat3 mat3_normal(const Mat4 *a);
#endif
