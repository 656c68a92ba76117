/* Silhouette shadows: shadow maps with the places where silhouettes of what is opaque cross between
 * the centres of texels. Found on the driver's side when maps are drawn (silhouette_find.glsl),
 * then kept as two bytes a texel (silhouette_pack.glsl); silhouette.glsl reads them. */
#ifndef MATC_SHADOW_SILHOUETTE_H
#define MATC_SHADOW_SILHOUETTE_H
#include "runtime/shadow/shadow_method.h"

/* An edge of edge_mesh.h: its ends, then the third corners of its faces; the same corner twice if
 * there is one face. */
typedef float SilhouetteEdge[4][3];

/* Edges of a mesh, in the buffer of all. */
typedef struct {
    int first, count;
} SilhouetteMesh;

typedef struct {
    GLuint crossings;       /* an array of two bytes a texel, a layer for each view that has them */
    GLuint extents;         /* buffer: crossings of a view while they are found */
    GLuint edges, places;   /* buffers: of all meshes; numbers of objects that a view sees */
    SilhouetteMesh *meshes; /* by the cache's meshes */
    int edge_count;
    Material find, pack;
} Silhouettes;

static inline Silhouettes *silhouette_state(const Render *render)
{
    return shadow_method_state(render, WORD_Shadows_silhouette);
}
/* How many views have crossings. */
int silhouette_layers(const Render *render);
/* Which of their layers a view has. */
int silhouette_layer(const Render *render, int view);
/* False: see the context's error. */
bool silhouette_make(Render *render);
/* In all views that have some; their maps are drawn. */
void silhouette_find(Render *render);
void silhouette_delete(Render *render);
#endif
