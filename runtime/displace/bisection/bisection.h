/* State of bisection on the GPU for a mesh, and declarations that its files share. */
#ifndef MATC_DISPLACE_BISECTION_H
#define MATC_DISPLACE_BISECTION_H
#include "gen/bisection_layout.h"
#include "runtime/displace/bisection/displaced_bisection.h"

/* Its buffers, bound in this order; but the mesh's rows are where BISECTION_CORNERS says, and what
 * follows them is one farther. */
enum {
    BISECTION_BASES,
    BISECTION_LEAVES,
    BISECTION_TABLE,
    BISECTION_WORK,
    BISECTION_RANGES,
    BISECTION_BUFFERS,
    BISECTION_CORNERS = BISECTION_RANGES
};
typedef enum {
    BISECTION_SCAN,
    BISECTION_LOOK,
    BISECTION_MERGE_CHOOSE,
    BISECTION_MERGE,
    BISECTION_CHOOSE,
    BISECTION_PACK_CHOOSE,
    BISECTION_PACK,
    BISECTION_BEGIN,
    BISECTION_FEW,
    BISECTION_STAGES
} BisectionStage;

/* Words of the state block: lights that cast shadows (LIGHT), the box of the shadow receivers
 * (BOX), and the half size of each light along the axes (EXTENT). */
typedef struct {
    int count;
    float each[BISECTION_LIGHTS_MOST][4], box[2][3], extent[BISECTION_LIGHTS_MOST][3];
} BisectionLights;

typedef struct {
    Material stages[BISECTION_STAGES]; /* splitting is the mesh's material */
    GLuint buffers[BISECTION_BUFFERS];
    /* for leaves now, and ever; bits of a place in the table */
    int room, most, table_bits;
    int ranged; /* ranges go so deep */
    int tile;   /* BISECTION_TILE_FEW or BISECTION_TILE_MANY */
    /* of merging and of splitting, that the last view took */
    int rounds[2];
    int stamp;   /* of entries of the table; 0: it has to be cleared */
    int coarser; /* fourths of an octave that an error may be larger */
    /* that an error could have when all leaves were looked at last; 0: they have to be */
    double pixels;
    /* since then: how far the camera has moved, and what came into the table */
    double gone, entries;
    /* around all points, wherever they may move; in the world */
    double box[2][3];
    /* the state block as last read; a buffer to read it */
    GLuint head[BISECTION_STATE_WORDS], head_copy;
    int splits, merges, looks, looked; /* of the last view; places that were looked at */
    SceneCamera camera;
    int size[2];
    BisectionLights lights;
} Bisection;

bool bisection_there(const GlContext *gl);
/* Programs and buffers, as `own`, without room for leaves. False: see the context's error. */
bool bisection_make(const DisplacedMaking *making, Displaced *made);
void bisection_forget(Displaced *displaced);
/* Room for so many leaves, and their corners in the mesh; those that there are stay. */
bool bisection_room(Displaced *displaced, Mesh *mesh, int room);
/* Bytes of the buffer of lists, for that many leaves. */
size_t bisection_work_bytes(const Bisection *b, size_t places);
/* And of that of leaves. */
size_t bisection_leaf_bytes(size_t places);
/* Its shadows count. */
bool bisection_casts(const SceneLight *light);
/* A uniform of all stages. */
void bisection_set(Displaced *displaced, const char *name, int lanes, const float *values);
void bisection_set_number(Displaced *displaced, const char *name, double number);
/* Uniforms of the view. */
void bisection_view_set(Displaced *displaced, const DisplacedView *view, const Mesh *mesh);
/* The first of those that cast shadows, as many as there is room for. */
BisectionLights bisection_view_lights(const DisplacedView *view);
/* How far the camera has moved from its last view, as bisect_see.glsl counts it; and what rounding
 * may hide of that. What else has changed makes all anew. */
void bisection_view_move(Displaced *displaced, const DisplacedView *view,
                         const BisectionLights *lights);
/* That a base's number has. */
int bisection_base_bits(const ScenePatches *patches);
#endif
