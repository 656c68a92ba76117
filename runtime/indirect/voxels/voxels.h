/* Voxel grid of a scene, as slice maps: cubes that are full or empty. A texel of the map is a
 * column along z; 128 of its voxels are the bits of an RGBA32UI texel: bit b of component l in
 * layer k is voxel 128 k + 32 l + b. For bodies, which are closed meshes, voxels are full whose
 * center lies inside; for all other meshes, voxels in which a line through voxel centers, along
 * x, y or z, hits a triangle. A path from center to center cannot cross a surface without
 * entering a full voxel. */
#ifndef MATC_INDIRECT_VOXELS_H
#define MATC_INDIRECT_VOXELS_H
#include "runtime/frame_graph/frame_pass.h"
#include "compiler/base/text.h"
#include "runtime/gpu_scene/gpu_scene.h"
#include "runtime/frame_graph/renderer_options.h"

enum {
    VOXELS_LAYERS_MAX = 4,
    VOXELS_LEVELS_MAX = 10,
    VOXELS_WAVES_MAX = 8,
    VOXELS_FINE = VOXELS_WAVES_MAX + 1
};

/* A cube of voxels around all objects, with at least one empty layer on each side. */
typedef struct {
    double low[3], edge; /* in world units: lowest corner of the grid; edge of a voxel */
    int size;            /* voxels along an edge of the grid */
} VoxelGrid;

/* Measurements of a mesh, in its local space. */
typedef struct {
    bool closed;
    double volume, area; /* enclosed volume; area of the triangles */
    double longest;      /* longest edge of the triangles */
} VoxelShape;

struct FrameVoxels {
    VoxelGrid grid;
    int layers, levels; /* size of the map; coarser levels exist for views only */
    VoxelShape *shapes; /* measurements, indexed by mesh of the GPU scene */
    /* Indexed by place of the GPU scene: 0, a surface; VOXELS_FINE, a surface of small
     * triangles; else a body, and the wave in which it is drawn. Bodies of one wave do not
     * overlap, since overlaps would cancel out. */
    unsigned char *waves;
    int wave_count;
    /* Interiors of closed meshes, in the form of the map; surfaces of others: R32UI, one word
     * per layer. */
    GLuint within, surface;
    /* Union of both; in a coarser level a texel is the union of 2 x 2. */
    GLuint map;
    GLuint bricks, buffer; /* the map as rays read it, an RG32UI buffer texture: voxel_bricks.c */
    GLuint framebuffer;
    /* Programs that fill `within`; `surface` (two); the map's finest level; coarser levels; the
     * bricks. */
    Material flip, touch, fine, merge, above, brick;
    GLuint fine_places;       /* storage buffer, filled from fine_rows: voxel_fine.c */
    float (*fine_rows)[3][4]; /* matrices, with capacity for all places of the GPU scene */
    bool drawn;               /* the map holds the current scene */
    ScreenPass view;
};

/* Fits the grid to all objects that fill voxels, or, without any, around the origin.
 * voxel_grid.c, which also has the next functions. */
VoxelGrid voxel_grid(const Scene *scene, const GpuScene *gpu_scene);
/* Computes clip space from world space for a view along an axis (0 to 2, x to z), which becomes
 * depth; x and y are the next two axes in cyclic order, for axis 1: z and x. */
void voxel_grid_clip(const VoxelGrid *grid, int axis, bool zero_to_one, double clip[16]);

/* An axis-aligned box in world space. */
typedef struct {
    double low[3], high[3];
} VoxelRange;
/* Extends a range by a transformed box. An empty range has low INFINITY and high -INFINITY. */
void voxel_grid_add(const CullBox *box, const SceneMatrix *world_from_local, VoxelRange *range);

/* voxel_bodies.c: measures meshes; sorts objects into bodies, with their waves, and surfaces.
 * False if memory runs out. A body is closed, and at least 1.5 voxels thick, by its volume over
 * half its area. Thinner meshes have voxels without a center inside, through which rays leak. A
 * mesh that overlaps too many others for the waves is treated as a surface. */
bool voxel_bodies_measure(const Renderer *renderer, FrameVoxels *voxels);
bool voxel_bodies_sort(const Renderer *renderer, FrameVoxels *voxels);
/* Kind of an opaque place of the GPU scene: a closed body; or a surface, for one of three reasons:
 * its mesh is open, it is too thin, or it overlaps too many others. */
typedef enum { VOXEL_body, VOXEL_open, VOXEL_thin, VOXEL_crossing, VOXEL_KINDS } VoxelKind;
VoxelKind voxel_bodies_kind(const Renderer *renderer, int place);
/* Returns the entry in `waves` of a place that is no body: 0, or VOXELS_FINE if its triangles
 * are small and compute programs are supported (voxel_fine.c). */
unsigned char voxel_bodies_surface(const Renderer *renderer, int place);
bool voxel_bodies_is_body(const FrameVoxels *voxels, int place);
/* Reports whether a place that fills voxels has that entry in `waves`. */
bool voxel_bodies_has(const FrameVoxels *voxels, const GpuScene *gpu_scene, int wave);

/* Returns the ray length in world units: the key `radius`, or a quarter of the longest edge of
 * the box around all objects. */
double voxel_grid_radius(const Scene *scene, const GpuScene *gpu_scene);

bool pass_voxels_needed(const Renderer *renderer);
/* Reports whether alpha-tested shadow casters depend on the time. */
bool pass_voxels_by_time(const Renderer *renderer);
/* Invalidates the map after a change of materials if alpha-tested objects fill voxels. */
void pass_voxels_forget(Renderer *renderer);
/* Sets the uniforms of a pass with voxel_map.glsl in its text: the unit of the bricks, and the
 * matrix from eye space to the grid. Call when the pass is made, and when the camera or objects
 * have moved. */
void pass_voxels_set(const Renderer *renderer, int unit, ScreenPass *pass);

/* voxel_fine.c: adds surfaces of small triangles to the texture `surface`, which is bound as
 * image 0. */
bool voxel_fine_make(Renderer *renderer);
void voxel_fine_draw(Renderer *renderer);

/* voxel_bricks.c: the bricks that rays read. Allocates them; fills them from the map; binds them
 * to a unit before each run of a pass that reads them; frees them. */
bool voxel_bricks_make(Renderer *renderer);
void voxel_bricks_draw(Renderer *renderer);
void voxel_bricks_bind(const Renderer *renderer, int unit);
void voxel_bricks_delete(Renderer *renderer);

/* Returns the level of a view "voxels", "voxels1" and so on; -1 for any other view or NULL.
 * voxels.c */
int voxels_view_level(const char *view);

/* Reports whether a place of the GPU scene fills voxels: it is opaque or alpha-tested. voxel_grid.c
 */
bool voxels_have(const GpuScenePlace *place);

/* Writes lines for --stats. */
void voxels_put(Text *out, const Renderer *renderer);

/* The rows of the frame graph. */
extern const FramePass pass_voxels, pass_cubes;
#endif
