/* State of bisection on the GPU for a mesh, and declarations that its files share. */
#ifndef MATC_DISPLACE_BISECTION_H
#define MATC_DISPLACE_BISECTION_H
#include "gen/bisection_layout.h"
#include "runtime/displace/bisection/displaced_bisection.h"

/* Buffers of the method, bound in this order, except that BISECTION_CORNERS is the binding of
 * the mesh's rows, and the buffers from there on are bound one higher. */
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

/* Words of the state block: lights that cast shadows (LIGHT), the bounding box of the shadow
 * receivers (BOX), and the half size of each light along the axes (EXTENT). */
typedef struct {
    int count;
    float each[BISECTION_LIGHTS_MAX][4], box[2][3], extent[BISECTION_LIGHTS_MAX][3];
} BisectionLights;

typedef struct {
    Material stages[BISECTION_STAGES]; /* the splitting stage is the mesh's material */
    GLuint buffers[BISECTION_BUFFERS];
    /* current and max capacity in leaves; log2 of the table's size */
    int capacity, most, table_bits;
    int ranged; /* depth up to which ranges are stored */
    int tile;   /* tile size: BISECTION_TILE_FEW or BISECTION_TILE_MANY */
    /* rounds of merging and of splitting in the last view */
    int rounds[2];
    int stamp;   /* generation of the table's entries; 0: the table must be cleared */
    int coarser; /* tolerance in excess of the requested one, in fourths of an octave */
    /* Tolerated deviation in pixels when all leaves were last evaluated; 0: all must be
     * evaluated. */
    double pixels;
    /* since all leaves were last evaluated: movement of the camera, entries added to the table */
    double gone, entries;
    /* bounding box of all displaced points, in world space */
    double box[2][3];
    /* `head` is the state block as last read; `head_copy` is a buffer for reading it */
    GLuint head[BISECTION_STATE_WORDS], head_copy;
    /* counts of the last view; `looked` counts evaluated slots */
    int splits, merges, looks, looked;
    SceneCamera camera;
    int size[2];
    BisectionLights lights;
} Bisection;

bool bisection_supported(const GlContext *gl);
/* Makes programs and buffers as `own`, without slots for leaves. False: failed, see the
 * context's error. */
bool bisection_make(const DisplacedMaking *making, Displaced *made);
void bisection_forget(Displaced *displaced);
/* Resizes the buffers to `capacity` leaves and their corners in the mesh; existing leaves are kept.
 */
bool bisection_capacity(Displaced *displaced, Mesh *mesh, int capacity);
/* Returns the bytes of the buffer of lists for `places` leaves. */
size_t bisection_work_bytes(const Bisection *b, size_t places);
/* Returns the bytes of the buffer of leaves for `places` leaves. */
size_t bisection_leaf_bytes(size_t places);
/* Returns whether the light casts shadows that bisection takes into account. */
bool bisection_casts(const SceneLight *light);
/* Sets a uniform in all stages. */
void bisection_set(Displaced *displaced, const char *name, int components, const float *values);
void bisection_set_number(Displaced *displaced, const char *name, double number);
/* Sets the uniforms of the view. */
void bisection_view_set(Displaced *displaced, const DisplacedView *view, const Mesh *mesh);
/* Returns the lights that cast shadows, up to the capacity of the state block. */
BisectionLights bisection_view_lights(const DisplacedView *view);
/* Adds the camera's movement since its last view, as bisect_see.glsl measures it, and sets its
 * rounding error. Any other change forces an evaluation of all leaves. */
void bisection_view_move(Displaced *displaced, const DisplacedView *view,
                         const BisectionLights *lights);
/* Returns the number of bits of a base's number. */
int bisection_base_bits(const ScenePatches *patches);
#endif
