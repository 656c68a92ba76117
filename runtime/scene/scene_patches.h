/* A mesh that is divided and displaced by whoever draws it: patches, which are triangles, and what
 * their points are moved by. */
#ifndef MATC_SCENE_PATCHES_H
#define MATC_SCENE_PATCHES_H
#include "runtime/scene/scene_sight.h"

enum { SCENE_PATCH_PARTS = 64 /* that an edge of a patch has at most */ };

/* Rows of ScenePatches: points within a patch are mixed of `own`; what moves the points of an edge,
 * or of a corner, is the same for all patches that have it, since these stand in one place. */
typedef struct {
    uint32_t own[3], corner[3];
    uint32_t edge[3][2]; /* edge k is opposite corner k, and leads from corner k + 1 to k + 2 */
} ScenePatch;

typedef struct ScenePatches {
    ShapeVertex *rows; /* those of the shape first */
    ScenePatch *at;
    int row_count, count;
    Word method; /* of the list Displacing */
    int material;
    SceneMatrix world_from_local;
    SceneDividing dividing;
    bool torn; /* what they become is not closed, even if they are */
    /* all edges of a patch have as many parts as the one that needs most, whatever its neighbour
     * has */
    bool apart;
    double bound;    /* no point moves farther in the world */
    double reach[3]; /* no point moves farther along the axes of the object's space */
    int level;       /* parts of an edge; of those that go by the picture at most */
    /* that an edge of the triangles they become is long in the picture; 0: all have `level`
     * parts */
    double pixels;
    int triangles; /* that they become at most then */
} ScenePatches;

/* Patches of a shape whose vertices differ from each other; the numbers behind row_count are not
 * set. False: memory ran out, *made is empty. */
bool scene_patches_make(const Shape *shape, ScenePatches *made);
/* Safe on an empty one. */
void scene_patches_free(ScenePatches *patches);
/* The vertices at the ends of edge k of a patch: the vertex with the lesser place comes first, and
 * first[i] is the place of vertex i (scene_places). Returns whether that turns them round, since
 * the edge leads from corner k + 1 to k + 2. */
bool scene_patch_ends(const ScenePatch *patch, const int *first, int k, uint32_t ends[2]);
/* Parts of the inside: those of the edge with the most. */
int scene_patch_parts(const uint8_t parts[3]);
/* A mesh and its patches; leaves an empty one behind. */
void scene_mesh_free(SceneMesh *mesh);
/* Patches that nobody sees may be left out: they go by the picture, and no point goes farther than
 * the height says. */
bool scene_patches_hide(const ScenePatches *patches);
/* Into how many parts edges 0 to 2 of each patch are divided as `camera` sees them, in a picture of
 * `size` pixels. Triangles that share an edge have the same number for it: it goes by the edge's
 * ends. It is a power of two, so that points of a coarser division are among those of a finer.
 * Triangles are at most as many as the patches say, as long as these are not more themselves.
 * Beyond `sight`, NULL: there is no end, patches that go by the picture are in 0 parts, all edges:
 * wherever their points are moved to, none is seen, nor its shadow. What a tenth of its distance
 * beside the view may come into it is kept. */
void scene_patches_levels(const ScenePatches *patches, const SceneCamera *camera, const int size[2],
                          const SceneSight *sight, uint8_t (*parts)[3]);
#endif
