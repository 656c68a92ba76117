/* The oracle: evaluates every channel of a resolved document at one surface point, in double
 * precision. It follows the rules of delegation one channel at a time and uses neither the IR
 * nor the lowering. Shaders are tested against it, and `matc --eval` prints its values. Uniforms
 * have their defaults. */
#ifndef MATC_ORACLE_H
#define MATC_ORACLE_H
#include "compiler/base/session.h"
#include "compiler/graph/graph.h"
#include "compiler/library/reference.h"

enum { CHANNEL_ID_COUNT = COMPONENTS_OF_GROUP * GROUP_COUNT };

static inline int channel_id(Group group, int component)
{
    return COMPONENTS_OF_GROUP * (int)group + component;
}

/* The shaded surface point. */
typedef struct {
    double root[CHANNEL_ID_COUNT]; /* values that a map without input reads, by channel id */
    bool front;                    /* the surface is front-facing */
    /* derivatives of the object position by u and v; finite derivatives do not read them */
    double local_u[3], local_v[3];
    /* derivatives by u and v of the mesh's normal; used by displacement only */
    double normal_u[3], normal_v[3];
    /* [k][d]: derivative of dP/du (k = 0) or dP/dv (1) by u (d = 0) or v (1); used by vector
     * displacement only */
    double tangent_slopes[2][2][3];
    /* Mesh attributes by the graph's index; valid where `has` has the bit 1 << (4 index +
     * component). */
    double attributes[LIMIT_ATTRIBUTES][4];
    uint32_t has; /* set of known components; others have their defaults, equal at all points */
} Surface;

/* Sets the default surface: front side, n = (0, 0, 1), dP/du = (1, 0, 0), dP/dv = (0, 1, 0),
 * viewed along n, ior 1, all else 0. */
void oracle_surface_default(Surface *surface);
/* Sets a channel by its name ("u", "px", ...). Returns false for an unknown channel, or one that
 * is always 0 at the surface (w, r, g, b, a). */
bool oracle_surface_set(Surface *surface, const char *name, double value);

/* Sets a mesh attribute by its name, all components ("wetness") or one component ("tint.x",
 * "tint.r"). Returns false if the graph has no such attribute. */
bool oracle_surface_attribute(const Graph *graph, Surface *surface, const char *name, double value);

typedef struct {
    /* components of slot_table[slot].type, unclamped; other components are 0 */
    double component[SLOT_COUNT][4];
} SlotValues;

/* State shared by the points of one document: baked textures and the memo. Not thread-safe. */
typedef struct Oracle Oracle;
/* Borrows `graph`; copies `context`, of which only the noise is used (textures come from the
 * document). */
Oracle *oracle_open(const Graph *graph, const ReferenceContext *context);
/* Sets how BumpMap computes slopes, a choice of --derivatives; initially auto. */
void oracle_derivatives(Oracle *oracle, Choice how);
/* Sets the span of the difference quotients of computed slopes, in steps of 2^-26 of the
 * surface's size, from `behind` to `ahead` of the point; initially -1 and 1. Spans from 0, or up
 * to 0, give one-sided derivatives. */
void oracle_slope_span(Oracle *oracle, double behind, double ahead);
/* Enables the check of whether the heights around a point lie on a smooth curve. They do not
 * where a stair has a step, or a million of them, within the span: the mean slope there is not
 * the stair's, which is 0. */
void oracle_judge_slopes(Oracle *oracle, bool judge);
/* Returns true if that check failed since the last call. */
bool oracle_slopes_rough(Oracle *oracle);
void oracle_close(Oracle *oracle);

/* Evaluates every shading slot of a material at a point. A NULL material is the gray of a
 * missing one. Returns false if the work exceeds LIMIT_WORK and the result is unknown. */
bool oracle_material(Oracle *oracle, const Node *material, const Surface *surface,
                     SlotValues *result);
/* Returns the work for the last point, in steps of about 5 ns. */
double oracle_work(const Oracle *oracle);
/* Displacement of a point along dP/du, dP/dv and the normal, followed by its derivatives by u
 * and by v; all 0: not displaced. For a volume: begin and end along the normal of its two solid
 * intervals. */
enum { ORACLE_HEIGHTS = 4 };
typedef struct {
    double by[ORACLE_HEIGHTS], by_u[ORACLE_HEIGHTS], by_v[ORACLE_HEIGHTS];
} OracleDisplacement;
bool oracle_displacement(Oracle *oracle, const Node *material, const Surface *surface,
                         OracleDisplacement *result);
/* Returns the material that displaces a surface, the given one or one that its switches choose;
 * NULL: none. */
const Node *oracle_displaced(const Node *material);
/* Evaluates the displacement without its slopes, in a fraction of the time. */
bool oracle_displacement_at(Oracle *oracle, const Node *material, const Surface *surface,
                            double by[ORACLE_HEIGHTS]);
/* Evaluates one channel of one map at a point. A NULL map is the surface. */
double oracle_channel(Oracle *oracle, const Node *map, int channel, const Surface *surface);
#endif
