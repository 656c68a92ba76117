/* Voxels of a scene: cubes that are full or empty, as slice maps. A texel of the map is a column
 * along z; 128 voxels of it are the bits of an RGBA32UI texel: bit b of lane l in layer k is voxel
 * 128 k + 32 l + b. Of bodies, which are closed, those are full whose middle lies within; of all
 * else, those in which a line through voxels' middles, along x, y or z, meets a triangle. No way
 * from middle to middle gets through a surface without meeting a full one. */
#ifndef MATC_INDIRECT_VOXELS_H
#define MATC_INDIRECT_VOXELS_H
#include "runtime/frame/frame_pass.h"
#include "compiler/base/text.h"
#include "runtime/cache/cache.h"
#include "runtime/frame/render_options.h"

enum {
    VOXELS_LAYERS_MOST = 4,
    VOXELS_LEVELS_MOST = 10,
    VOXELS_WAVES_MOST = 8,
    VOXELS_FINE = VOXELS_WAVES_MOST + 1
};

/* A cube of cubes around all objects, with one empty layer at least on each side. */
typedef struct {
    double low[3], edge; /* in the world: its lowest corner; of a voxel */
    int size;            /* voxels along an edge of the whole */
} VoxelGrid;

/* Properties of a mesh, in its own space. */
typedef struct {
    bool closed;
    double volume, area; /* within it; of its triangles */
    double longest;      /* of its triangles' edges */
} VoxelShape;

struct FrameVoxels {
    VoxelGrid grid;
    int layers, levels; /* the map's: those above are for views alone */
    VoxelShape *shapes; /* by mesh of the cache */
    /* By place of the cache: 0, a surface; VOXELS_FINE, one of small triangles; else a body, and
     * the wave in which it is drawn: bodies of one wave are apart, as what is met twice is
     * empty. */
    unsigned char *waves;
    int wave_count;
    /* of closed meshes, in the form of the map; of others: R32UI, a word in each layer */
    GLuint within, surface;
    /* both; a level above has a texel for 2 x 2, where any of them is full */
    GLuint map;
    GLuint bricks, buffer; /* as rays read it: a texture of a buffer's, RG32UI: voxel_bricks.c */
    GLuint framebuffer;
    /* into within; surface, both; the map's lowest level, those above, bricks */
    Material flip, touch, fine, merge, above, brick;
    GLuint fine_places;       /* a buffer, and what it gets: voxel_fine.c */
    float (*fine_rows)[3][4]; /* room for each place of the cache */
    bool drawn;               /* the map holds the scene */
    ScreenPass view;
};

/* Around what fills voxels; without any: around the origin. voxel_grid.c, as is what follows. */
VoxelGrid voxel_grid(const Scene *scene, const Cache *cache);
/* Clip space from the world: z is depth along an axis (0 to 2, x to z), x and y the axes behind it
 * in turn: 1 has z and x. */
void voxel_grid_clip(const VoxelGrid *grid, int axis, bool zero_to_one, double clip[16]);

/* A box in the world. */
typedef struct {
    double low[3], high[3];
} VoxelRange;
/* Grows it around another box, where that stands. From INFINITY and -INFINITY on. */
void voxel_grid_add(const CullBox *box, const SceneMatrix *world_from_local, VoxelRange *range);

/* voxel_bodies.c. What meshes are; which objects are bodies, in which waves. False: memory ran out.
 * A body is closed, and at least 1.5 voxels thick: its volume over half its area. What is thinner
 * has voxels without a middle in it, through which a ray gets. What crosses more than can be apart
 * is a surface. */
bool voxel_bodies_measure(const Render *render, FrameVoxels *voxels);
bool voxel_bodies_sort(const Render *render, FrameVoxels *voxels);
/* Kind of an opaque place of the cache: a closed body; or a surface, and why: its mesh is open, it
 * is too thin, it crosses too many others. */
typedef enum { VOXEL_body, VOXEL_open, VOXEL_thin, VOXEL_crossing, VOXEL_KINDS } VoxelKind;
VoxelKind voxel_bodies_kind(const Render *render, int place);
/* Entry in `waves` of a place that is no body: 0, or VOXELS_FINE if its triangles are small and
 * there are programs for these (voxel_fine.c). */
unsigned char voxel_bodies_surface(const Render *render, int place);
bool voxel_bodies_is_body(const FrameVoxels *voxels, int place);
/* Something that fills voxels is in that wave, or is such a surface. */
bool voxel_bodies_has(const FrameVoxels *voxels, const Cache *cache, int wave);

/* How far rays go, in the world's units: the key `radius`, or a quarter of the longest edge of the
 * box around all objects. */
double voxel_grid_radius(const Scene *scene, const Cache *cache);

bool pass_voxels_needed(const Render *render);
/* Shadow casters depend on the time. */
bool pass_voxels_by_time(const Render *render);
/* Materials are others, and with them what is cut out. */
void pass_voxels_forget(Render *render);
/* Tells a pass that has voxel_map.glsl in its text which unit the bricks are bound to, and where
 * the eye is in them: when it is made, and when the camera or objects have moved. */
void pass_voxels_set(const Render *render, int unit, ScreenPass *pass);

/* voxel_fine.c. Adds surfaces of small triangles to the texture `surface`, which is bound as image
 * 0. */
bool voxel_fine_make(Render *render);
void voxel_fine_draw(Render *render);

/* voxel_bricks.c. What rays read: room for it, from the map, to a unit, before each run of a pass
 * that reads it. */
bool voxel_bricks_make(Render *render);
void voxel_bricks_draw(Render *render);
void voxel_bricks_bind(const Render *render, int unit);
void voxel_bricks_delete(Render *render);

/* Level of a view "voxels", or "voxels1" and so on; -1: it is another view, or none. voxels.c */
int voxels_view_level(const char *view);

/* A place of the cache fills voxels: it is opaque, or cut out. voxel_grid.c */
bool voxels_have(const CachePlace *place);

/* Lines on them, for --stats. */
void voxels_put(Text *out, const Render *render);

/* The rows of the frame graph. */
extern const FramePass pass_voxels, pass_cubes;
#endif
