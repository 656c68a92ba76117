/* Vectors and matrices in double for the reference of frames, independent of the renderer's. */
#ifndef MATC_REFERENCE_SPACE_H
#define MATC_REFERENCE_SPACE_H
#include "runtime/scene/scene.h"

double reference_dot(const double a[3], const double b[3]);
void reference_cross(const double a[3], const double b[3], double out[3]);
/* Length 1; not of nothing. */
void reference_normalize(double v[3]);
/* Image of a point (w 1) or a vector (w 0). */
void reference_image(const SceneMatrix *m, const double v[3], double w, double out[3]);
/* The preimage, likewise. */
void reference_preimage(const SceneMatrix *m, const double v[3], double w, double out[3]);
/* A normal's image: linear in the normal, and at a right angle to the images of what it is at a
 * right angle to. */
void reference_across(const SceneMatrix *m, const double n[3], double out[3]);
/* Image of a normal, of length 1. */
void reference_normal(const SceneMatrix *m, const double n[3], double out[3]);
#endif
