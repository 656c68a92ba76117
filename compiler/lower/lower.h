/* Graph -> Ir. A map is asked for a group of channels in an environment; what it does not define it passes on to its
 * input, and no input is the surface. */
#ifndef MATC_LOWER_H
#define MATC_LOWER_H
#include "compiler/lower/affine.h"

/* What the root of the delegation answers. Filters evaluate their input in an environment of their own. */
typedef struct {
    Ref root[GROUP_COUNT];
    Ref front;  /* bool: seen from the front */
    Ref eye_n;  /* the root normal in eye space, 0 if only eyeFromWorld can tell */
    int number; /* for the memo: of how many filters it is the inside */
} Env;

/* Along what a value is differentiated: to the next pixel on the screen, and by the surface's own u and v. */
typedef enum { DIRECTION_right, DIRECTION_up, DIRECTION_u, DIRECTION_v, DIRECTION_COUNT } Direction;

typedef struct {
    uint64_t key; /* node, group, environment; 0 is empty */
    Ref value;
} Memo;

/* A value that is one of two all over the pixel: a for a share of it, b for the rest. No share: it is not known to be. */
typedef struct {
    Ref share, a, b;
} Split;

typedef struct {
    Ref u, v;
} Slopes;

/* What a chain of UVTransforms makes of slopes: those of one are turned by it, those of several by the product of all. */
typedef struct {
    bool known;
    int count;             /* of transforms */
    const Node *transform; /* of one */
    Slopes column[2];      /* of several: what becomes of (1, 0) and of (0, 1) */
} Turn;

typedef struct {
    Session *session;
    Ir *ir;
    const Graph *graph;
    Memo *memo;
    size_t memo_count, memo_mask;
    const Job *job;
    Simplify *simplify;             /* the local rules; NULL in the IR at -O0 */
    int filters;                    /* under way: Smooth3D, Laplace3D */
    bool cheap;                     /* forms that are cheaper but not the plainest: -O1 and up */
    Ref (*slopes)[DIRECTION_COUNT]; /* by Ref: derivatives found so far; slope.c */
    size_t slope_room;
    Ref *to_differ; /* stack of values whose derivatives are under way; slope.c */
    size_t to_differ_count, to_differ_room;
    Ref *variances; /* by Ref; footprint.c */
    size_t variance_room;
    Ref *to_vary; /* stack of values whose variances are under way; footprint.c */
    size_t to_vary_count, to_vary_room;
    Split *splits; /* by Ref; footprint.c */
    size_t split_room;
    Ref *settled; /* by Ref: the constant that it is; settled.c */
    size_t settled_room;
    Ref settled_count;
    Turn *turns; /* by node; lower_normal.c */
    size_t turn_room;
    Affine affine;        /* affine.c */
    uint8_t *uniform_use; /* by uniform: 1 as a count, 2 as a number */
    bool failed;          /* a diagnostic was made */
} Lower;

/* The point of a rasterised surface. lower_pass.c */
Env lower_surface_env(Lower *l);
/* What a job's program computes of a material. NULL: see the diagnostics. */
Ir *lower(Session *session, const Graph *graph, const Node *material, const Job *job, Simplify *simplify);

/* Group of channels of a map; NULL is the surface. R has the type its map makes, IOR is a float, the rest are vec3. */
Ref lower_ask(Lower *l, const Node *map, Group group, const Env *env);
void lower_mark_head(Ir *ir, Ref value, uint8_t hint);
/* A colour as another group's value: lane 0 for IOR, three lanes otherwise. */
Ref lower_as_group(Lower *l, Ref value, Group group);
/* The type that holds colours of both types lane by lane. A float stands for all lanes and a vec2 for two, hence a vec3. */
Type lower_common_type(Type a, Type b);
/* A parameter's value as IR, converted to the type. */
Ref lower_param(Lower *l, const Value *value, Type type);
/* The map in a parameter, NULL if it has none. */
const Node *lower_param_node(const Node *node, int param);
/* Reports a param where the value must be known. */
void lower_reject_uniform(Lower *l, const Value *value, const char *name, const char *why);
/* Cost of a value, up to `limit`: an upper bound, as shared parts count as often as they are met. */
int lower_cost_below(const Ir *ir, Ref ref, int limit);
/* One material slot, by its name. lower_material.c */
Ref lower_slot(Lower *l, const Node *material, Slot slot, const Env *env);
/* The shading normal in eye space, unit length, turned to the viewer. */
Ref lower_eye_normal(Lower *l, const Node *material, const Env *env);
/* Writes every render target of the job's layout, by that case of it. lower_layout.c */
void lower_layout(Lower *l, int number, const Node *material, const Env *env);
/* The case of the layout that the material takes; their number: none stores all that it has. The IR must simplify, so that
 * constants are seen. */
int lower_layout_case(Lower *l, const Node *material, const Env *env);
/* Says that there is none. */
void lower_no_case(Lower *l, const Node *material, const Env *env);
/* The slots that a case of a layout made for a set must store for the material to take it, 1 << slot; alpha is in the
 * transparency. */
unsigned lower_needed_slots(Lower *l, const Node *material, const Env *env);
Ref lower_wave(Lower *l, const Wave *wave, Ref v);
/* Derivatives by u and v -> the one by the coordinate that a UVTransform makes: with J the inverse of its matrix,
 * d/du' = d/du J00 + d/dv J10, d/dv' likewise. Tangents or slopes; GROUP_DU or GROUP_DV. */
Ref lower_uv_tangent(Lower *l, const Node *node, Ref du, Ref dv, Group group);
/* M q for a Transform. */
Ref lower_transform(Lower *l, const Transform *transform, Ref q);

#define MAP(name, function, lowering, cost, doc)                                                                       \
    Ref lower_##name(Lower *l, const Node *node, Group group, const Env *env);
#include "grammar/maps.def"

/* Shorthands for building. */
#define add(l, a, b) ir_binary((l)->ir, OP_add, a, b)
#define sub(l, a, b) ir_binary((l)->ir, OP_sub, a, b)
#define mul(l, a, b) ir_binary((l)->ir, OP_mul, a, b)
static inline Ref number(Lower *l, double value) { return ir_float(l->ir, value); }
#endif
