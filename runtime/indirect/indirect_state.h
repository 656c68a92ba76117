/* What a frame keeps of voxels, cached radiance and indirect light: data alone, of the passes in
 * runtime/indirect. */
#ifndef MATC_INDIRECT_INDIRECT_STATE_H
#define MATC_INDIRECT_INDIRECT_STATE_H
#include "runtime/frame/frame.h"
#include "runtime/draw/screen_pass.h"
#include "runtime/scene/scene.h"

/* A cube of cubes around all objects, with one empty layer at least on each side. */
typedef struct {
    double low[3], edge; /* in the world: its lowest corner; of a voxel */
    int size;            /* voxels along an edge of the whole */
} VoxelGrid;

/* Of a mesh, in its own space. */
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

struct FrameRadiance {
    Material *keepers; /* by kind of the cache: its program, which ends in nodes */
    int keeper_count;
    unsigned char *casts; /* by place */
    Material number;      /* gives the nodes of a voxel their numbers */
    /* what lamps have nodes send; what these have each other send */
    ScreenPass light, bounce;
    GLuint faces, nodes, kept;       /* buffers */
    GLuint faces_words, kept_texels; /* the first and the last as rays read them */
    GLuint framebuffer;
    /* voxels along an edge: those of the map, or RADIANCE_SIZE_MOST; half as often as nodes do not
     * find room */
    int size;
    GLuint room; /* nodes that the buffers have room for */
    GLuint count;
    bool drawn; /* it holds the scene */
};

typedef struct {
    /* by object: where it stood when rays were kept last; NULL: nothing is kept */
    SceneMatrix *kept;
    int first, end;   /* objects of these may have moved since */
    Material number;  /* draws them */
    Framebuffer seen; /* whole numbers: 0, or which motion; made when something has moved */
} IndirectMotion;

/* What rays found in frames before: of pass_history.c. */
typedef struct {
    ScreenPass blend, place;
    Framebuffer values[2], places[2]; /* one is kept, the other drawn to */
    int last;                         /* the one that is kept */
    int sets;                         /* of rays that are in it, since something changed */
    unsigned number;                  /* of all sets */
    /* something is kept; nothing has changed since; it is as exact as is wanted */
    bool there, still, exact;
    unsigned doubts;           /* a sum of IndirectDoubt */
    double eye_from_world[16]; /* of the view that it was seen in */
    float ray[4], depth[4];
} IndirectHistory;

/* Passes of fewer pixels, while something moves, in a part of the same targets. */
typedef struct {
    bool on; /* something is another than in the frame before */
    ScreenPass rays, again, smooth, spread;
    Framebuffer found, smoothed; /* the targets rays and smooth */
} IndirectMoving;

/* Of the passes. */
struct FrameIndirect {
    IndirectHistory history;
    IndirectMoving moving;
    Framebuffer between; /* of levels of the filter atrous: the target open, or a part of it */
    IndirectMotion motion;
    ScreenPass rays, again, smooth, spread, combine; /* again: rays of further bounces */
};

/* Of pass_positions.c. */
struct FramePositions {
    Material material;
    GLuint array; /* without a buffer: vertices are numbers */
};
#endif
