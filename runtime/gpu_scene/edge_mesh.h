/* Edges of a mesh that may be silhouettes, or where shading is discontinuous. Adjacency of faces
 * is found by positions, so that vertices with different attributes match. Makes no GL calls. */
#ifndef MATC_RENDER_EDGE_MESH_H
#define MATC_RENDER_EDGE_MESH_H
#include "runtime/gl/shape.h"

typedef struct {
    float ends[2][3];
    float normals[2][3]; /* normals of the two adjacent faces; not normalized */
    float apexes[2][3];  /* the faces' third vertices */
    /* The number of faces at the edge is not two: the edge is always a silhouette. */
    bool open;
    bool crease; /* the shading normal is discontinuous along the edge */
} MeshEdge;

typedef struct {
    MeshEdge *edges;
    int count;
    bool solid;             /* the mesh is closed, with front faces outside */
    double low[3], high[3]; /* bounding box */
} EdgeMesh;

/* Finds the edges of a shape. Returns false if memory runs out, with *made empty. */
bool edge_mesh_make(const Shape *shape, EdgeMesh *made);
/* Frees the mesh; safe on an empty one. */
void edge_mesh_free(EdgeMesh *mesh);
#endif
