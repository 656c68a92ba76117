/* Affine matrices and vectors of a scene, in double. */
#ifndef MATC_SCENE_MATRIX_H
#define MATC_SCENE_MATRIX_H
#include "compiler/base/vec3.h"
#include "compiler/graph/graph.h"
#include "runtime/scene/scene.h"

SceneMatrix scene_matrix_identity(void);
/* Returns the product a b, which applies b first. */
SceneMatrix scene_matrix_multiply(const SceneMatrix *a, const SceneMatrix *b);
/* Parts of a transformation, in order of application: shear, scale, rotation about x, y, z
 * (radians), translation. */
typedef struct {
    double translation[3], rotation[3], scale[3], shear[3];
} ScenePlace;
SceneMatrix scene_matrix_place(const ScenePlace *place);
/* Returns the matrix of a document's transformation, whose values are numbers. */
SceneMatrix scene_matrix_of(const Transform *transform);
/* Inverts a matrix; returns false if it is singular. */
bool scene_matrix_invert(const SceneMatrix *m, SceneMatrix *inverse);
/* Returns the determinant of the upper left part. */
double scene_matrix_determinant(const SceneMatrix *m);

/* Completes the unit vector `along` to an orthonormal basis with along = x cross y. */
void scene_vector_axes(const double along[3], double x[3], double y[3]);
#endif
