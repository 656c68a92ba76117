/* Welds vertices of a mesh that are equal bit for bit in position, normal, texture coordinates
 * and extra attributes. */
#ifndef MATC_SCENE_MODEL_JOIN_H
#define MATC_SCENE_MODEL_JOIN_H
#include "compiler/base/hash_index.h"
#include "runtime/mesh_import/model.h"

/* Welding makes triangles with separate corners adjacent:
 *     corners  a b c  c b d     vertices  a b c d     joined  0 1 2  2 1 3 */
typedef struct {
    Shape *shape; /* the element after the last vertex is the candidate for model_join_add */
    int first;    /* earlier vertices belong to other meshes */
    HashIndex index;
    uint32_t *joined; /* indexed by corner: vertex index */
} ModelJoin;

/* Returns false if memory runs out. Call model_join_close in both cases. */
bool model_join_open(ModelJoin *join, Shape *shape, unsigned corners);
/* Finds the candidate vertex among this mesh's vertices, or appends it, and stores its index in
 * joined[corner]. Returns false if the shape has MODEL_VERTICES vertices already. */
bool model_join_add(ModelJoin *join, unsigned corner);
void model_join_close(ModelJoin *join);
#endif
