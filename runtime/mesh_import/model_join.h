/* Joins equal vertices of a mesh: those that agree in position, normal, coordinates and extras, bit
 * for bit. */
#ifndef MATC_SCENE_MODEL_JOIN_H
#define MATC_SCENE_MODEL_JOIN_H
#include "compiler/base/hash_index.h"
#include "runtime/mesh_import/model.h"

/* Triangles with corners of their own become neighbors:
 *     corners  a b c  c b d     vertices  a b c d     joined  0 1 2  2 1 3 */
typedef struct {
    Shape *shape; /* the vertex behind its last is the next to be joined */
    int first;    /* vertices before are of other meshes */
    HashIndex index;
    uint32_t *joined; /* by corner: its vertex */
} ModelJoin;

/* False: out of memory; close it all the same. */
bool model_join_open(ModelJoin *join, Shape *shape, unsigned corners);
/* Finds the vertex behind the last among those of this mesh, or adds it. False: the shape has
 * MODEL_VERTICES already. */
bool model_join_add(ModelJoin *join, unsigned corner);
void model_join_close(ModelJoin *join);
#endif
