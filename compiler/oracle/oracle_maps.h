/* Declarations shared by the files of the oracle: an environment to query maps in, and the value of
 * every kind of map. */
#ifndef MATC_ORACLE_MAPS_H
#define MATC_ORACLE_MAPS_H
#include "compiler/base/session.h"
#include "compiler/oracle/oracle.h"

/* Numbers of the nodes that were met, in that order. */
typedef struct {
    const Node **at;
    size_t count, room;
    HashIndex index;
} NodeNumbers;
/* A node's number, a new one when it is met first. oracle_memo.c */
size_t node_number(Arena *arena, NodeNumbers *numbers, const Node *node);

/* A node's answers, valid when the stamp is that of the environment. */
typedef struct {
    uint64_t stamp;
    uint32_t known; /* 1 << channel */
    double value[CHANNEL_ID_COUNT];
} MemoRow;
typedef struct {
    NodeNumbers nodes;
    MemoRow *rows; /* by their numbers */
    size_t room;
} Memo;

/* Transform of slopes by u and v through the UVTransforms from a node down its inputs. */
typedef struct {
    bool known;
    double m[2][2];
} SlopeTurn;

/* A SunSkyLight's sky_coefficients: the scaled zenith, A to E, the unit vector to the sun. They
 * contain an integral. */
enum { SKY_ROW_ZENITH, SKY_ROW_A, SKY_ROW_SUN = SKY_ROW_A + 5, SKY_ROW_COUNT };
typedef struct {
    bool known;
    double numbers[5]; /* the sun, turbidity, radianceFactor */
    double rows[SKY_ROW_COUNT][3];
} OracleSky;

struct Oracle {
    Arena arena;
    const Graph *graph;
    ReferenceContext context;
    NodeNumbers baked;
    float **reliefs; /* by number: a Carpenter's texels; NULL until first read */
    size_t relief_room;
    NodeNumbers turned;
    SlopeTurn *turns; /* by number */
    size_t turn_room;
    Memo *memos; /* by depth of environments */
    size_t memo_count, memo_room;
    OracleSky sky;        /* the last one */
    Choice derivatives;   /* how BumpMap finds slopes */
    double behind, ahead; /* the steps that those of what is computed are taken over */
    /* whether it is asked if heights are smooth there; whether some were not */
    bool judges, rough;
    uint64_t stamp; /* that of the environment opened last; 0 is in no environment */
    double work;    /* steps for this point; beyond LIMIT_WORK all answers are 0 */
};

/* A surface point in which maps are asked. A filter opens further ones, each a depth below its own,
 * and a BumpMap beside the point. */
typedef struct Environment {
    Oracle *oracle;
    const Surface *surface;
    uint64_t stamp;
    int depth;
    struct Environment
        /* with --derivatives=auto: the point that this one is beside; NULL: it is beside none */
        *centre;
    const Surface *mesh; /* the surface before it was displaced; NULL: it was not */
    /* the point that this one is beside, whatever --derivatives; NULL: it is beside none */
    struct Environment *origin;
    struct Environment *outer; /* where a Triplanar is that asks its maps here; NULL: none does */
    const Node *triplanar;     /* that one, and the axis along which it looks */
    int axis;
} Environment;
Environment environment_open(Oracle *oracle, const Surface *surface, int depth);

/* Cached value of a map in the environment; false: none yet. oracle_memo.c */
bool memo_find(const Environment *environment, const Node *node, int channel, double *value);
void memo_set(const Environment *environment, const Node *node, int channel, double value);

/* A channel of a map; NULL is the surface. Remembered for the environment. */
double oracle_ask(Environment *environment, const Node *map, int channel);
/* A channel of the map that a parameter holds. */
double oracle_ask_param(Environment *environment, const Node *node, int param, int channel);
/* A channel of a map's `input`, and three of them: lanes 0..2 of a group. */
double oracle_ask_input(Environment *environment, const Node *node, int channel);
void oracle_ask_input3(Environment *environment, const Node *node, Group group, double result[3]);

/* Numbers and uniforms: a value, and the value of a parameter. */
double oracle_float(const Value *value);
void oracle_vec3(const Value *value, double result[3]);
double oracle_number(const Node *node, int param);
void oracle_number3(const Node *node, int param, double result[3]);

/* A number that varies over the surface. */
typedef struct {
    double (*at)(Environment *environment, const Node *node, int lane);
    const Node *node;
    int lane;
} Height;
/* Its derivatives by u and v. oracle_normal.c */
void oracle_slopes(Environment *environment, const Height *height, double slope[2]);
/* Slopes of a smooth height to a few ulp, instead of a difference's 1e-8; several times as costly.
 * */
void oracle_slopes_exact(Environment *environment, const Height *height, double slope[2]);
/* Environment of a Triplanar's map of an axis; the outer environment must live as long.
 * oracle_triplanar.c */
typedef struct {
    Surface surface;
    Environment environment;
} Projection;
void oracle_project(Environment *outer, const Node *triplanar, int axis, Projection *made);
/* How such a material moves the point; the surface's frame after it was displaced, as its normal
 * and tangents. oracle_displacement.c */
void oracle_move(Environment *environment, const Node *displaced, OracleDisplacement *result);
void oracle_move_by(Environment *environment, const Node *displaced, double move[ORACLE_HEIGHTS]);
void oracle_displace(Environment *environment, const Node *displaced, Surface *surface);

/* Work of the oracle, in steps of some 5 ns. oracle_work.c */
enum {
    ANSWER_WORK = 100, /* of every answer: delegation and memory */
    CALL_WORK = 3,     /* of an operation of a reference, as grammar/ counts those of its GLSL */
    ITEM_WORK = 3,     /* of an item of a Blend that is passed by */
    WAVE_WORK = 10,    /* of a wave, alone or in a chain */
    TEXEL_WORK = 12    /* of a texel that a Carpenter bakes */
};
/* Adds to the point's work. */
void oracle_spend(const Environment *environment, double steps);
/* It is more than LIMIT_WORK. */
bool oracle_spent(const Oracle *oracle);
/* Calls the C reference of a library function, and adds its cost. */
void oracle_call(const Environment *environment, int function, const double *args, double *result);

/* w(frequency value + phase) of a map with VOLUME_PARAMS. */
double oracle_waved(const Environment *environment, const Node *node, double value);
/* Every channel of a volume map is the same value, a derivative channel too, and only a fourth lane
 * is 1. It is remembered for the lanes beside the one that was asked for. */
double oracle_same_of_all(const Environment *environment, const Node *node, int channel,
                          double value);

/* A map as a function of its coordinate, and GroIMP's steps for its differences. */
typedef struct {
    double (*at)(const void *map, const double q[3]);
    const void *map;
    double step[3]; /* 0: it does not go by that lane */
} Stepped;
/* f at q0, and from there on to q along the differences (f(q0 + h e) - f(q0)) / h: what jumps
 * becomes linear beside the point. */
double oracle_along_steps(const Stepped *map, const double q0[3], const double q[3]);
/* How much a Checker or VolumeChecker has of its color1: 1 or 0 at the point that is shaded, and
 * beside it along its steps. */
double oracle_odd_share(Environment *environment, const Node *checker);

/* Derivatives by u and v -> by the coordinates that a UVTransform makes of them. */
void oracle_uv_slopes(const Node *node, double slope[2]);
/* Transforms slopes by all UVTransforms from a map down its inputs; NULL is the surface. */
void oracle_turn_slopes(Oracle *oracle, const Node *input, double slope[2]);

static inline Group group_of(int channel) { return (Group)(channel / LANES_OF_GROUP); }
static inline int lane_of(int channel) { return channel % LANES_OF_GROUP; }
/* One of the lanes x, y, z of a group: what a map that answers the group as a triple defines. */
static inline bool in_triple(int channel, Group group)
{
    return group_of(channel) == group && lane_of(channel) < 3;
}
/* Ids 8..14 of semantics.md, which leave out the fourth lane of DV. */
static inline bool is_derivative(int channel)
{
    return channel >= channel_id(GROUP_DU, 0) && channel <= channel_id(GROUP_DV, 2);
}

/* Value of a channel of a map: oracle_<kind> for each map that is not a plain function of its
 * position. */
typedef double Answer(Environment *environment, const Node *node, int channel);
Answer oracle_answer; /* any map: chooses by its kind */
Answer oracle_volume; /* LOWERING_VOLUME */
#define DECLARE_OWN(name) Answer oracle_##name;
#define DECLARE_VOLUME(name)
#define MAP(name, function, lowering, cost, doc) DECLARE_##lowering(name)
#include "grammar/maps.def"
#undef DECLARE_OWN
#undef DECLARE_VOLUME
/* Functions that materials share. oracle_material.c */
/* of a parameter's map */
void oracle_ask_colour(Environment *environment, const Node *node, int param, double rgb[3]);
/* unit length, on the side that is seen */
void oracle_set_normal(const Environment *environment, const double normal[3], SlotValues *result);
const Node *oracle_material_of(const Node *material, int param); /* NULL: there is none */
/* Slots of one side of a material, converted to the model of the whole. */
void oracle_answer_as(Environment *environment, const Node *whole, const Node *side,
                      SlotValues *result);
bool oracle_is_principled(const Environment *environment, const Node *material);
void oracle_as_principled(SlotValues *side); /* of a Phong's slots. oracle_principled.c */
/* Slots of a material, written over those of a neutral one. oracle_material.c */
#define DECLARE_SHADER(name)                                                                       \
    void oracle_##name(Environment *environment, const Node *material, SlotValues *result);
/* The material that a switch stands for, seen of one side; NULL: it is missing. */
#define DECLARE_SWITCH(name) const Node *oracle_choose_##name(const Node *material, bool front);

#define DECLARE_FOREIGN(name)     /* none is left: compiler/resolve/resolve_translation.c */
#define MATERIAL(name, sort, doc) DECLARE_##sort(name)
#include "grammar/materials.def"
#include "grammar/maps.def"
#undef DECLARE_SHADER
#undef DECLARE_SWITCH
#undef DECLARE_FOREIGN
#endif
