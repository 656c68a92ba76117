/* Silhouette shadows: shadow maps with the crossings of opaque silhouettes between the centers
 * of texels. Crossings are found on the GPU after the maps are drawn (silhouette_find.glsl), and
 * stored as two bytes per texel (silhouette_pack.glsl); silhouette.glsl reads them. */
#ifndef MATC_SHADOW_SILHOUETTE_H
#define MATC_SHADOW_SILHOUETTE_H
#include "runtime/shadow/shadow_method.h"

/* An edge of edge_mesh.h: its ends, then the third corners of its faces; the same corner twice
 * if there is one face. */
typedef float SilhouetteEdge[4][3];

/* Range of a mesh's edges in the shared buffer. */
typedef struct {
    int first, count;
} SilhouetteMesh;

typedef struct {
    GLuint crossings; /* array of two bytes per texel, a layer for each view with crossings */
    GLuint extents;   /* buffer for the extents of a view's crossings while they are found */
    /* buffers of the edges of all meshes, and of the numbers of the objects in a view */
    GLuint edges, places;
    SilhouetteMesh *meshes; /* ranges of edges, indexed by mesh of the GPU scene */
    int edge_count;
    Material find, pack;
} Silhouettes;

static inline Silhouettes *silhouette_state(const Renderer *renderer)
{
    return shadow_method_state(renderer, KEYWORD_Shadows_silhouette);
}
/* Returns the number of views with crossings. */
int silhouette_layers(const Renderer *renderer);
/* Returns the layer of a view among the views with crossings. */
int silhouette_layer(const Renderer *renderer, int view);
/* Makes the programs and buffers. False: failed, see the context's error. */
bool silhouette_make(Renderer *renderer);
/* Finds crossings in all views that need them, after their maps are drawn. */
void silhouette_find(Renderer *renderer);
void silhouette_delete(Renderer *renderer);
#endif
