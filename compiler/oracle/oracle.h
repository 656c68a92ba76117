/* The oracle: the value of every channel of a resolved document at one surface point, in double
 * precision. It follows the rules of delegation one channel at a time and knows neither the IR nor
 * the lowering; shaders are tested against it, and `matc --eval` prints it. Uniforms have their
 * defaults. */
#ifndef MATC_ORACLE_H
#define MATC_ORACLE_H
#include "compiler/base/session.h"
#include "compiler/graph/graph.h"
#include "compiler/library/reference.h"

enum { CHANNEL_ID_COUNT = LANES_OF_GROUP * GROUP_COUNT };

static inline int channel_id(Group group, int lane) { return LANES_OF_GROUP * (int)group + lane; }

/* The point that is shaded. */
typedef struct {
    double root[CHANNEL_ID_COUNT]; /* what a map without input reads, by channel id */
    bool front;                    /* seen from the front */
    /* how the object position changes by u and v; finite derivatives do not read it */
    double local_u[3], local_v[3];
    /* how the normal does, as the mesh has it: only displacement asks */
    double normal_u[3], normal_v[3];
    /* how dP/du (0) and dP/dv (1) do, by u (0) and by v (1): of vectors that displace alone */
    double tangent_slopes[2][2][3];
    /* of the mesh, by the graph's index, where `has` says so: 1 << (4 index + lane) */
    double attributes[LIMIT_ATTRIBUTES][4];
    uint32_t has; /* else they have their defaults; they do not change from point to point */
} Surface;

/* Front side, n = (0, 0, 1), dP/du = (1, 0, 0), dP/dv = (0, 1, 0), seen along n, ior 1, the rest
 * 0. */
void oracle_surface_default(Surface *surface);
/* Sets a channel by its name ("u", "px", ...). false: no such channel, or one that no surface sets
 * (w, r, g, b, a). */
bool oracle_surface_set(Surface *surface, const char *name, double value);

/* Sets an attribute of the mesh by its name, all lanes ("wetness") or one of them ("tint.x",
 * "tint.r"). false: the graph has none. */
bool oracle_surface_attribute(const Graph *graph, Surface *surface, const char *name, double value);

typedef struct {
    double lane[SLOT_COUNT][4]; /* lanes of slot_table[slot].type; the rest 0. Not clamped. */
} SlotValues;

/* State that the points of one document share: baked textures and the memo. Not for two threads at
 * once. */
typedef struct Oracle Oracle;
/* Keeps `graph`; copies `context`, of which only the noise is used (textures come from the
 * document). */
Oracle *oracle_open(const Graph *graph, const ReferenceContext *context);
/* From now on BumpMap goes by that choice of --derivatives; first it is auto. */
void oracle_derivatives(Oracle *oracle, Choice how);
/* Derivatives of what is computed are differences over this many steps of 2^-26 of the surface's
 * size, from behind the point to ahead of it: -1 and 1 at first. From 0 on, or up to 0, they are
 * those of one side. */
void oracle_slope_span(Oracle *oracle, double behind, double ahead);
/* From now on it is asked, or not, whether differences tell slopes: whether the heights around a
 * point lie on a smooth curve. They do not where a stair has a step or a million of them within the
 * span: their mean slope is not the stair's, which is 0. */
void oracle_judge_slopes(Oracle *oracle, bool judge);
/* Some heights did not, since this was asked last. */
bool oracle_slopes_rough(Oracle *oracle);
void oracle_close(Oracle *oracle);

/* Every shading slot of a material at a point. A NULL material is the grey that stands for a
 * missing one. False: it takes more than LIMIT_WORK steps, and is not known. */
bool oracle_material(Oracle *oracle, const Node *material, const Surface *surface,
                     SlotValues *result);
/* Work of the last point, in steps of about 5 ns. */
double oracle_work(const Oracle *oracle);
/* How far the material moves the point: along dP/du, dP/dv and the normal, before the slopes of
 * these by u and by v. All 0: it is not displaced. Of a volume: from where to where it is solid
 * along the normal, twice. */
enum { ORACLE_HEIGHTS = 4 };
typedef struct {
    double by[ORACLE_HEIGHTS], by_u[ORACLE_HEIGHTS], by_v[ORACLE_HEIGHTS];
} OracleDisplacement;
bool oracle_displacement(Oracle *oracle, const Node *material, const Surface *surface,
                         OracleDisplacement *result);
/* The material that displaces a surface, which may be one that this one chooses; NULL: none
 * does. */
const Node *oracle_displaced(const Node *material);
/* The first of these alone, which takes a fraction of the time. */
bool oracle_displacement_at(Oracle *oracle, const Node *material, const Surface *surface,
                            double by[ORACLE_HEIGHTS]);
/* One channel of one map at a point. A NULL map is the surface. */
double oracle_channel(Oracle *oracle, const Node *map, int channel, const Surface *surface);
#endif
