/* Internal declarations of the oracle: an environment in which maps are evaluated, and the
 * evaluation of every kind of map. */
#ifndef MATC_ORACLE_MAPS_H
#define MATC_ORACLE_MAPS_H
#include "compiler/base/session.h"
#include "compiler/oracle/oracle.h"

/* Visited nodes, numbered in order of their first visit. */
typedef struct {
    const Node **at;
    size_t count, capacity;
    HashIndex index;
} NodeNumbers;
/* Returns the number of a node, assigned on its first visit. oracle_memo.c */
size_t node_number(Arena *arena, NodeNumbers *numbers, const Node *node);

/* Cached values of a node, valid while the stamp equals the environment's. */
typedef struct {
    uint64_t stamp;
    uint32_t known; /* set of known channels: bits 1 << channel */
    double value[CHANNEL_ID_COUNT];
} MemoRow;
typedef struct {
    NodeNumbers nodes;
    MemoRow *rows; /* cached values, indexed by node number */
    size_t capacity;
} Memo;

/* Transform of slopes by u and v through the UVTransforms from a node down its inputs. */
typedef struct {
    bool known;
    double m[2][2];
} SlopeTurn;

/* Coefficients of a SunSkyLight's sky (sky_coefficients): the scaled zenith, A to E, the unit
 * vector to the sun. Cached, since they contain an integral. */
enum { SKY_ROW_ZENITH, SKY_ROW_A, SKY_ROW_SUN = SKY_ROW_A + 5, SKY_ROW_COUNT };
typedef struct {
    bool known;
    /* inputs of the coefficients: the sun's direction, turbidity, radianceFactor */
    double numbers[5];
    double rows[SKY_ROW_COUNT][3];
} OracleSky;

struct Oracle {
    Arena arena;
    const Graph *graph;
    ReferenceContext context;
    NodeNumbers baked;
    float **reliefs; /* indexed by node number: a Carpenter's texels; NULL until first read */
    size_t relief_capacity;
    NodeNumbers turned;
    SlopeTurn *turns; /* transforms of slopes, indexed by node number */
    size_t turn_capacity;
    Memo *memos; /* caches of map values, indexed by nesting depth of environments */
    size_t memo_count, memo_capacity;
    OracleSky sky;        /* coefficients for the last SunSkyLight */
    Choice derivatives;   /* method by which BumpMap computes slopes */
    double behind, ahead; /* the span of difference quotients, in steps; oracle_slope_span() */
    /* `judges`: smooth heights are checked; `rough`: the check failed */
    bool judges, rough;
    uint64_t stamp; /* stamp of the last opened environment; 0: invalid */
    double work;    /* work for this point, in steps; above LIMIT_WORK all values are 0 */
};

/* A surface point at which maps are evaluated. A filter opens further environments, each one
 * level deeper, and a BumpMap opens some at adjacent points. */
typedef struct Environment {
    Oracle *oracle;
    const Surface *surface;
    uint64_t stamp;
    int depth;
    /* The point to which this one is adjacent, unless --derivatives=analytic; NULL: not
     * adjacent. */
    struct Environment *centre;
    const Surface *mesh; /* the surface before displacement; NULL: not displaced */
    /* the point to which this one is adjacent, for any --derivatives; NULL: not adjacent */
    struct Environment *origin;
    struct Environment *outer; /* environment of the Triplanar whose map is evaluated; NULL: none */
    const Node *triplanar;     /* the Triplanar whose map is evaluated along `axis` */
    int axis;
} Environment;
Environment environment_open(Oracle *oracle, const Surface *surface, int depth);

/* Finds the cached value of a map in the environment; false: the value is not cached.
 * oracle_memo.c */
bool memo_find(const Environment *environment, const Node *node, int channel, double *value);
void memo_set(const Environment *environment, const Node *node, int channel, double value);

/* Evaluates a channel of a map; NULL is the surface. Cached per environment. */
double oracle_query(Environment *environment, const Node *map, int channel);
/* Evaluates a channel of the map that a parameter holds. */
double oracle_query_param(Environment *environment, const Node *node, int param, int channel);
/* Evaluates a channel of a map's `input`, or components 0..2 of a group. */
double oracle_query_input(Environment *environment, const Node *node, int channel);
void oracle_query_input3(Environment *environment, const Node *node, Group group, double result[3]);

/* Return numbers, from literals or uniforms: of a value, or of a parameter. */
double oracle_float(const Value *value);
void oracle_vec3(const Value *value, double result[3]);
double oracle_number(const Node *node, int param);
void oracle_number3(const Node *node, int param, double result[3]);

/* A number that varies over the surface, as a function of the point. */
typedef struct {
    double (*at)(Environment *environment, const Node *node, int component);
    const Node *node;
    int component;
} Height;
/* Computes the derivatives of a height by u and v. oracle_normal.c */
void oracle_slopes(Environment *environment, const Height *height, double slope[2]);
/* Computes the derivatives of a smooth height to a few ulp, instead of a difference's 1e-8;
 * several times as costly. */
void oracle_slopes_exact(Environment *environment, const Height *height, double slope[2]);
/* Environment in which a Triplanar evaluates the map of an axis; `outer` must outlive the
 * projection. oracle_triplanar.c */
typedef struct {
    Surface surface;
    Environment environment;
} Projection;
void oracle_project(Environment *outer, const Node *triplanar, int axis, Projection *made);
/* Compute the displacement of the point by a material, with slopes and without; and the
 * surface's normal and tangents after displacement. oracle_displacement.c */
void oracle_move(Environment *environment, const Node *displaced, OracleDisplacement *result);
void oracle_move_by(Environment *environment, const Node *displaced, double move[ORACLE_HEIGHTS]);
void oracle_displace(Environment *environment, const Node *displaced, Surface *surface);

/* Costs of evaluation in steps of some 5 ns. oracle_work.c */
enum {
    MAP_VALUE_WORK = 100, /* work per map value: delegation and memory */
    /* work per operation of a reference; grammar/ counts the operations of its GLSL */
    CALL_WORK = 3,
    ITEM_WORK = 3,  /* work per skipped item of a Blend */
    WAVE_WORK = 10, /* work per wave, alone or in a chain */
    TEXEL_WORK = 12 /* work per texel that a Carpenter bakes */
};
/* Adds to the cost of evaluating the point. */
void oracle_spend(const Environment *environment, double steps);
/* Returns true if the work exceeds LIMIT_WORK. */
bool oracle_spent(const Oracle *oracle);
/* Calls the C reference of a library function, and adds its cost. */
void oracle_call(const Environment *environment, int function, const double *args, double *result);

/* Returns w(frequency value + phase), for a map with VOLUME_PARAMS. */
double oracle_waved(const Environment *environment, const Node *node, double value);
/* Caches the value of a volume map for the first three components of the channel's group, which
 * are equal, and returns it. Derivative channels have the same value; only a fourth component is
 * 1. */
double oracle_same_of_all(const Environment *environment, const Node *node, int channel,
                          double value);

/* A map as a function of its coordinate, and GroIMP's steps of its finite differences. */
typedef struct {
    double (*at)(const void *map, const double q[3]);
    const void *map;
    double step[3]; /* step of the difference quotient; 0: independent of the component */
} Stepped;
/* Returns f at q0, extrapolated to q along the difference quotients (f(q0 + h e) - f(q0)) / h: a
 * discontinuous map becomes linear near the point. */
double oracle_along_steps(const Stepped *map, const double q0[3], const double q[3]);
/* Returns the share of color1 in a Checker or VolumeChecker: 1 or 0 at the shaded point, and
 * extrapolated along its steps at adjacent points. */
double oracle_odd_share(Environment *environment, const Node *checker);

/* Converts derivatives by u and v to those by the coordinates that a UVTransform makes. */
void oracle_uv_slopes(const Node *node, double slope[2]);
/* Transforms slopes by all UVTransforms from a map down its inputs; NULL is the surface. */
void oracle_turn_slopes(Oracle *oracle, const Node *input, double slope[2]);

static inline Group group_of(int channel) { return (Group)(channel / COMPONENTS_OF_GROUP); }
static inline int component_of(int channel) { return channel % COMPONENTS_OF_GROUP; }
/* Returns true for components x, y, z of a group, which a map defines as a triple. */
static inline bool in_triple(int channel, Group group)
{
    return group_of(channel) == group && component_of(channel) < 3;
}
/* Returns true for the derivative channels: ids 8..14 of semantics.md, without the fourth
 * component of DV. */
static inline bool is_derivative(int channel)
{
    return channel >= channel_id(GROUP_DU, 0) && channel <= channel_id(GROUP_DV, 2);
}

/* Evaluates a channel of a map: oracle_<kind> for each map that is not a plain function of its
 * position. */
typedef double MapValue(Environment *environment, const Node *node, int channel);
MapValue oracle_map_value; /* evaluates any map: dispatches on its kind */
MapValue oracle_volume;    /* declares oracle_volume for LOWERING_VOLUME */
#define DECLARE_OWN(name) MapValue oracle_##name;
#define DECLARE_VOLUME(name)
#define MAP(name, function, lowering, cost, doc) DECLARE_##lowering(name)
#include "grammar/maps.def"
#undef DECLARE_OWN
#undef DECLARE_VOLUME
/* Functions shared by several materials, from oracle_material.c. */
/* Evaluates the RGB of a parameter's map. */
void oracle_query_colour(Environment *environment, const Node *node, int param, double rgb[3]);
/* Stores a normal with unit length, flipped to the visible side. */
void oracle_set_normal(const Environment *environment, const double normal[3], SlotValues *result);
/* Returns the material of a parameter; NULL: none. */
const Node *oracle_material_of(const Node *material, int param);
/* Evaluates the slots of one side of a material, converted to the surface model of the whole. */
void oracle_map_value_as(Environment *environment, const Node *whole, const Node *side,
                         SlotValues *result);
bool oracle_is_principled(const Environment *environment, const Node *material);
/* Converts the slots of a Phong. oracle_principled.c */
void oracle_as_principled(SlotValues *side);
/* Evaluates a material's slots, written over those of a neutral material. oracle_material.c */
#define DECLARE_SHADER(name)                                                                       \
    void oracle_##name(Environment *environment, const Node *material, SlotValues *result);
/* The material that a switch chooses for a side; NULL: missing. */
#define DECLARE_SWITCH(name) const Node *oracle_choose_##name(const Node *material, bool front);

#define DECLARE_FOREIGN(name)     /* translated: compiler/resolve/resolve_translation.c */
#define MATERIAL(name, sort, doc) DECLARE_##sort(name)
#include "grammar/materials.def"
#include "grammar/maps.def"
#undef DECLARE_SHADER
#undef DECLARE_SWITCH
#undef DECLARE_FOREIGN
#endif
