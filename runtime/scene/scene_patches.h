/* A mesh that the GPU subdivides and displaces: patches, which are triangles, and the attributes
 * by which their points are displaced. */
#ifndef MATC_SCENE_PATCHES_H
#define MATC_SCENE_PATCHES_H
#include "runtime/scene/scene_sight.h"

enum { SCENE_PATCH_PARTS = 64 /* max parts of a patch's edge */ };

/* Indices of rows in ScenePatches. Points inside a patch interpolate the rows `own`. Points of
 * an edge or a corner are displaced by the same rows in all patches that share it, so that no
 * crack opens. */
typedef struct {
    uint32_t own[3], corner[3];
    uint32_t edge[3][2]; /* edge k is opposite corner k, and leads from corner k + 1 to k + 2 */
} ScenePatch;

typedef struct ScenePatches {
    ShapeVertex *rows; /* vertices, those of the shape first */
    ScenePatch *at;
    int row_count, count;
    Keyword method; /* keyword of the list Displacing */
    int material;
    SceneMatrix world_from_local;
    SceneDividing dividing;
    bool torn; /* the result is not watertight, even if the patches are */
    /* Every edge of a patch gets the part count of the patch's most divided edge, regardless of
     * adjacent patches. */
    bool apart;
    double bound;    /* max displacement of a point in world units */
    double reach[3]; /* max displacement along the axes of local space */
    int level;       /* parts of an edge; max parts if they depend on the picture */
    /* Target edge length of the final triangles in pixels; 0: all edges have `level` parts. */
    double pixels;
    int triangles; /* max number of final triangles if parts depend on the picture */
} ScenePatches;

/* Makes patches of a shape with distinct vertices; fields after row_count are not set. Returns
 * false if memory runs out, with *made empty. */
bool scene_patches_make(const Shape *shape, ScenePatches *made);
/* Frees the patches; safe on empty ones. */
void scene_patches_free(ScenePatches *patches);
/* Returns the end vertices of edge k of a patch, that with the smaller position index first;
 * first[i] is the position index of vertex i (scene_places). Returns true if this order is
 * opposite to the edge's direction, from corner k + 1 to k + 2. */
bool scene_patch_ends(const ScenePatch *patch, const int *first, int k, uint32_t ends[2]);
/* Returns the parts of a patch's interior: the max over its edges. */
int scene_patch_parts(const uint8_t parts[3]);
/* Frees a mesh and its patches, and leaves it empty. */
void scene_mesh_free(SceneMesh *mesh);
/* Reports whether invisible patches may be left out: their subdivision depends on the picture,
 * and no point moves farther than the height. */
bool scene_patches_hide(const ScenePatches *patches);
/* Computes the parts of edges 0 to 2 of each patch as viewed by `camera`, in a picture of `size`
 * pixels. Triangles that share an edge get the same number, since it depends only on the edge's
 * ends. Numbers are powers of two, so that points of a coarser subdivision are among those of a
 * finer one. The number of triangles stays within the patches' limit, unless there are more
 * patches.
 *
 * Outside `sight` (NULL: unlimited) patches that depend on the picture get 0 parts for all
 * edges: neither they nor their shadows are visible, wherever their points are displaced.
 * Patches within a tenth of their distance from the view are kept. */
void scene_patches_levels(const ScenePatches *patches, const SceneCamera *camera, const int size[2],
                          const SceneFrustums *sight, uint8_t (*parts)[3]);
#endif
