/* Vectors and matrices in double for the reference of frames, independent of the renderer's. */
#ifndef MATC_REFERENCE_SPACE_H
#define MATC_REFERENCE_SPACE_H
#include "runtime/scene/scene.h"

double reference_dot(const double a[3], const double b[3]);
void reference_cross(const double a[3], const double b[3], double out[3]);
/* Normalizes a vector other than 0. */
void reference_normalize(double v[3]);
/* Transforms a point (w 1) or a vector (w 0). */
void reference_image(const SceneMatrix *m, const double v[3], double w, double out[3]);
/* Transforms by the inverse matrix. */
void reference_preimage(const SceneMatrix *m, const double v[3], double w, double out[3]);
/* Transforms a normal by the inverse transpose, up to length: linear in the normal, and
 * perpendicular to the images of its tangents. */
void reference_across(const SceneMatrix *m, const double n[3], double out[3]);
/* Transforms a normal, and normalizes. */
void reference_normal(const SceneMatrix *m, const double n[3], double out[3]);
#endif
