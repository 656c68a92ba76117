/* Small matrices in GL's layout: floats by columns, m[4 * column + row]. */
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
/* Returns the product a b, which applies b first. */
Mat4 mat4_multiply(const Mat4 *a, const Mat4 *b);

/* Perspective projection. `height`: tangent of half the vertical angle; `aspect`: width /
 * height; near and far are positive distances. */
Mat4 mat4_perspective(float height, float aspect, float near, float far);

/* World to eye space: the eye looks along -z, and y is as close to `up` as possible. `up` must
 * not be parallel to the viewing direction. */
Mat4 mat4_look_at(const float eye[3], const float target[3], const float up[3]);

/* Returns false for a singular matrix, and leaves *inverse unchanged. */
bool mat4_inverse(const Mat4 *a, Mat4 *inverse);

Mat3 mat3_from_mat4(const Mat4 *a); /* Returns the upper left 3 x 3 matrix. */
Mat3 mat3_multiply(const Mat3 *a, const Mat3 *b);

/* Returns the normal matrix of `a`: the inverse transpose of its upper left part, up to a
 * positive factor, so that a singular matrix is allowed. Transformed normals are not of unit
 * length. */
Mat3 mat3_normal(const Mat4 *a);
#endif
