/* Lowering: Graph -> Ir. A map is queried for a group of channels in an environment. It passes a
 * group that it does not define on to its input; a missing input is the surface itself. */
#ifndef MATC_LOWER_H
#define MATC_LOWER_H
#include "compiler/lower/affine.h"

/* Values of the surface, where the chain of queries ends. A filter evaluates its input in an
 * environment of its own. */
typedef struct {
    Ref root[GROUP_COUNT];
    Ref front; /* bool: the surface is front-facing */
    bool seen; /* a viewer of the surface exists */
    /* Set for a displacement, which depends on positions alone: attributes have their defaults,
     * and the object's random number is 0. */
    bool shape;
    Ref eye_n;  /* the root normal in eye space; 0: apply eyeFromWorld */
    int number; /* part of the memo key: depth of nested filters and Triplanar's Place */
    /* Set within a displacement whose slopes by u and v are wanted; part of the memo key. bump.c */
    bool relief;
} Env;

/* Directions of differentiation: to the next pixel on the screen (right, up), and along the
 * surface's own u and v. */
typedef enum { DIRECTION_right, DIRECTION_up, DIRECTION_u, DIRECTION_v, DIRECTION_COUNT } Direction;

/* A map's value: with --aa its mean over the pixel, and its known variation there.
 * The variation depends on the queried maps, never on IR nodes: where the builder merges two
 * values into one node, each value keeps its own, so programs of all -O levels antialias alike.
 * map_value.h */
typedef struct {
    Ref value;
    /* Variance within the pixel, per component, that the mean's slope does not account for; has
     * the value's type; 0: none. */
    Ref variance;
    const struct Split *split; /* two values between which the pixel is split; NULL: unknown */
} MapValue;

/* A value that is one of two everywhere in the pixel; nonlinear operations must be applied to
 * both. */
typedef struct Split {
    Ref by; /* share of the pixel that has a's value; or a bool: all of the pixel has */
    MapValue a, b;
} Split;

typedef struct {
    uint64_t key; /* key of node, group and environment; 0: the entry is empty */
    MapValue answer;
    bool averaged; /* this map, or a map below, was averaged over the pixel */
} Memo;

/* The cached last result of lower_slot() for a slot. */
typedef struct {
    const Node *material;
    int number;    /* number of the material's environment */
    bool averaged; /* the value depends on a mean over the pixel, as in Memo */
    Ref value;     /* value of the slot; 0: the slot has not been lowered yet */
} SlotValue;

typedef struct {
    Ref u, v;
} Slopes;

/* UV transform chain: the product of nested UVTransforms, applied to slopes. */
typedef struct {
    bool known;
    int count;             /* number of transforms in the chain */
    const Node *transform; /* the only transform, if `count` is 1 */
    Slopes column[2];      /* valid if count > 1: images of (1, 0) and (0, 1) */
} UvTransformChain;

/* An environment's number is PLACE_STRIDE * place + filter depth; the stride is above
 * LIMIT_FILTERS. */
enum { PLACE_STRIDE = 8 };
/* An environment in which a Triplanar queries its maps: a texture coordinate within the
 * environment of number `outer`. */
typedef struct {
    Ref uv;
    int outer;
} Place;

/* A map that --aa=auto may average, with the group that was queried. */
typedef struct {
    const Node *map;
    Group group;
    /* queried where the pass begins, not at a Triplanar's place or in a displacement */
    bool outside;
} MetMap;
typedef struct {
    MetMap *at;
    size_t count, capacity;
    bool mingled; /* means share slopes and footprints with other computations of the program */
} MapList;

/* Options of node construction. */
typedef struct {
    bool cheap;         /* -O1 and up: use cheaper forms instead of the plainest */
    Simplify *simplify; /* the local simplification rules; NULL in the IR at -O0 */
} Manner;

typedef struct {
    Session *session;
    Ir *ir;
    const Graph *graph;
    Memo *memo;
    size_t memo_count, memo_mask;
    const Job *job;
    Simplify *simplify;  /* the local simplification rules; NULL in the IR at -O0 */
    int filters;         /* current nesting of Smooth3D and Laplace3D */
    const Node *map;     /* the map that is being lowered */
    MapList averageable; /* maps that --aa=auto may average; budget.c */
    int averaged_below;  /* maps of a lower index in the document are averaged */
    bool averaged;       /* the current map, or a map below, was averaged */
    /* Current nesting of alternatives that are likely to become a branch. */
    int arms;
    bool relief;                    /* set within a displacement of --derivatives=auto; bump.c */
    Manner outside;                 /* options outside of the displacement */
    bool cheap;                     /* -O1 and up: use cheaper forms instead of the plainest */
    Ref (*slopes)[DIRECTION_COUNT]; /* derivatives found so far, by Ref; slope.c */
    size_t slope_capacity;
    struct LateSum **sums; /* per Ref: the derivatives of a value, given as sums; slope_sum.c */
    size_t sum_capacity;
    Ref *to_differ; /* stack of values to differentiate; slope.c */
    size_t to_differ_count, to_differ_capacity;
    Place *places; /* the places of all Triplanars; lower_triplanar.c */
    size_t place_count, place_capacity;
    HashIndex place_index;
    UvTransformChain *turns; /* UV transform chains by node; lower_normal.c */
    size_t turn_capacity;
    SlotValue asked[SLOT_COUNT];
    struct SlotMemo *slots; /* per node and slot: values of mixed materials; lower_mix.c */
    Affine affine;          /* state of affine.c: affine forms of values */
    unsigned layout_slots;  /* the slots that the job's layout stores: layout_slots() */
    uint8_t *uniform_use;   /* per uniform: 1 used as a count, 2 as a number */
    /* Blends whose coordinates are checked at the end, last first; lower_lint.c. */
    const struct Crossing *crossing;
    /* displacements whose slopes are checked, last first */
    const struct DisplacementFound *reliefs;
    bool detached; /* slopes were marked by OP_detach as a footprint's */
    bool failed;   /* a diagnostic was reported */
} Lower;

/* Returns the environment of a point of a rasterized surface. lower_pass.c */
Env lower_surface_env(Lower *l);
/* Lowers a material to the IR of a job's program. NULL: failed, with diagnostics. */
Ir *lower(Session *session, const Graph *graph, const Node *material, const Job *job,
          Simplify *simplify);

/* The arguments of lower(). */
typedef struct {
    Session *session;
    const Graph *graph;
    const Node *material;
    const Job *job;
    Simplify *simplify;
} LowerRequest;
/* Lowers with means for the maps of an index below `below` only, as --aa=auto does;
 * l->averageable then lists the maps that could have a mean. lower_pass.c */
Ir *lower_averaging(Lower *l, const LowerRequest *what, int below);
/* Returns the cost in operations of the program without means, after `l` has lowered the program
 * with means: values that contain no mean are reused. `l` cannot lower anything afterwards.
 * Negative: failure. lower_pass.c */
int lower_cost_of_points(const Lower *l, const Node *material);
/* Starts a lowering of single maps, and makes the environment that its pass begins with.
 * lower_pass.c */
Lower lower_start(const LowerRequest *what, int optimize);
Env lower_pass_env(Lower *l);

/* Lowers a map's group of channels; a NULL map is the surface. R has the type that the map
 * makes, IOR is a float, the others are vec3. */
MapValue lower_map_value(Lower *l, const Node *map, Group group, const Env *env);
/* Returns the value alone of lower_map_value(). */
Ref lower_query(Lower *l, const Node *map, Group group, const Env *env);
/* Estimate from the cost tables: operations of a map or material without means, counted up to
 * `limit`, and the number of its maps that may be averaged. */
typedef struct {
    int points, averageable;
} MapCosts;
MapCosts lower_map_costs(const Node *map, int limit);
/* Returns true if the map is costly enough to be computed only where it is visible. */
bool lower_wants_branch(const Node *map);
/* Calls lower_map_value() for a map that is one of several alternatives, whose evaluation may move
 * into a branch. */
MapValue lower_arm(Lower *l, const Node *map, Group group, const Env *env);
void lower_mark_head(Ir *ir, Ref value, uint32_t origin);
/* Converts a color to another group's value: component 0 for IOR, otherwise three components. */
Ref lower_as_group(Lower *l, Ref value, Group group);
/* Returns a parameter's value as IR, converted to `type`. */
Ref lower_param(Lower *l, const Value *value, Type type);
/* Returns the map that is a parameter's value; NULL: none. */
const Node *lower_param_node(const Node *node, int param);
/* Reports an error if a parameter whose value must be known is a uniform. */
void lower_reject_uniform(Lower *l, const Value *value, const char *name, const char *why);
/* Returns the cost of a value, up to `limit`: an upper bound, since a shared part counts once
 * per use. lower_cost.c */
int lower_cost_below(const Ir *ir, Ref ref, int limit);
/* Lowers one slot of a material. lower_material.c */
Ref lower_slot(Lower *l, const Node *material, Slot slot, const Env *env);
/* Returns the material whose parameters displace a surface: the material itself, or the one its
 * switches choose, with a SideSwitch taken from the front; NULL: none. lower_material.c */
const Node *lower_displaced(const Node *material);
/* Returns the displacement of a point (lower_displacement.c): a float along the normal, or a
 * vec3 along dP/du, dP/dv and the normal; for a volume a vec4, the two solid intervals along the
 * normal. */
Ref lower_displacement(Lower *l, const Node *displaced, const Env *env);
/* Returns the environment of the displaced surface: normal and tangents follow the slopes of the
 * displacement, all else is as in `env`. */
Env lower_displaced_env(Lower *l, const Node *displaced, const Env *env);
/* Writes displacement and slopes as colors; or, for vertex stages, without screen-space
 * derivatives. `displaced` may be NULL. */
void lower_write_displacement(Lower *l, const Node *displaced, const Env *env);
void lower_displace_vertices(Lower *l, const Node *displaced);
/* Normal of a surface with these tangents that is displaced along `unit` with the given slopes.
 * It points to the side that the mesh's tangents define. lower_normal.c */
typedef struct {
    Ref tu, tv; /* tangents before displacement */
    Ref unit;   /* n / |n|; 0 if |n| is 0 */
    Ref flat;   /* vector whose side decides; 0: cross(tu, tv) */
} Frame;
Ref lower_raised_normal(Lower *l, const Frame *f, const Ref slope[2]);
/* Returns n / |n|; 0 if |n| is 0. */
Ref lower_unit(Lower *l, Ref n);
/* Returns the derivative of n / |n|: the part of `change` perpendicular to n, over |n|. n = (0,
 * 0, 2) and a change of (1, 0, 1): (.5, 0, 0). */
Ref lower_unit_slope(Lower *l, Ref n, Ref change);

/* Parameters of a clear coat, which belongs to a Principled or to a Layer. lower_coat.c */
typedef struct {
    const Node *of;
    int weight, color, roughness, ior, darkening, roughening, normal;
} Coat;
#define COAT_OF(node, kind)                                                                        \
    {                                                                                              \
        node, P_##kind##_coat, P_##kind##_coatColor, P_##kind##_coatRoughness, P_##kind##_coatIor, \
            P_##kind##_coatDarkening, P_##kind##_coatRoughening, P_##kind##_coatNormal             \
    }
/* Returns a slot of the coat over a base of the given diffuse color. */
Ref lower_coat_slot(Lower *l, const Coat *coat, Slot slot, Ref diffuse, const Env *env);
/* Returns the coat's normal, a direction, where the coat's weight is above 0; (0, 0, 0) where
 * the coat follows the base's normal. */
Ref lower_coat_normal(Lower *l, const Coat *coat, const Env *env);
/* Return slots of the surface below a coat: its apparent roughness, its reflectance at normal
 * incidence from its index of refraction relative to air, and its emission. */
Ref lower_coated_roughness(Lower *l, const Coat *coat, Ref roughness, const Env *env);
Ref lower_coated_reflectance(Lower *l, const Coat *coat, Ref ior, const Env *env);
Ref lower_coated_emission(Lower *l, const Coat *coat, Ref sent, const Env *env);
/* Returns the index of refraction of a thin film below a coat, clamped to its slot's range. */
Ref lower_coated_film(Lower *l, const Coat *coat, Ref ior, const Env *env);
Ref lower_film_ior(Ir *ir, Ref ior);
/* Returns a slot of a lobe; its `absent` value where `weight` is not above 0. */
Ref lower_where_there(Ir *ir, Ref weight, Slot slot, Ref value);
/* Returns the Fresnel reflectance at normal incidence: ((ior - 1) / (ior + 1))^2. */
Ref lower_reflectance(Ir *ir, Ref ior);

/* Returns the shading normal as the G-buffer stores it: in eye or world space, of unit length,
 * facing the viewer. */
Ref lower_stored_normal(Lower *l, const Node *material, const Env *env);
/* Returns the coat's own normal, in the same form; (0, 0, 0) if the coat has none of its own. */
Ref lower_stored_coat_normal(Lower *l, const Node *material, const Env *env);
/* Returns the slot anisotropy about the stored normal. lower_principled.c */
Ref lower_stored_anisotropy(Lower *l, const Node *material, const Env *env);
/* Writes every render target of the job's layout, as case `number` of the layout packs them.
 * lower_layout.c */
void lower_layout(Lower *l, int number, const Node *material, const Env *env);
/* Returns the number of the first case of the layout that stores all slots that the material
 * has; the case count if no case does. Needs an IR with simplification, so that constants are
 * recognized. */
int lower_layout_case(Lower *l, const Node *material, const Env *env);
/* Returns the number of the case that loses the fewest slots, which a warning lists; the case
 * count if the layout is not for all materials, or no case stores the model. */
int lower_nearest_case(Lower *l, const Node *material, const Env *env);
/* Warns of a slot that no case of a layout for all Principled materials stores. */
void lower_left_out(Lower *l, const Node *material, const Env *env);
/* Reports the error that no case of the layout stores the material. */
void lower_no_case(Lower *l, const Node *material, const Env *env);
/* Returns the bits (1 << slot) of the slots that a case of a layout made for a set must store to
 * fit the material; alpha is part of the transparency. */
unsigned lower_needed_slots(Lower *l, const Node *material, const Env *env);
/* Records the coordinate of a Blend with items, and the slopes of a displacement (0: none), for
 * lower_lint(). lower_lint.c */
void lower_note_crossing(Lower *l, const Node *blend, Ref coordinate);
void lower_note_bump(Lower *l, const Node *displacement, Ref by_u, Ref by_v);
/* Warns, after lowering, of Blends whose items are never reached, and of displacements whose
 * slopes are all 0. */
void lower_lint(Lower *l);
MapValue lower_wave(Lower *l, const Wave *wave, MapValue v);
/* Applies a wave: w(frequency f + phase), where w is the node's wave; the node's first four
 * parameters are those of VOLUME_PARAMS. */
MapValue lower_waved(Lower *l, const Node *node, MapValue f);
/* Converts derivatives by u and v to the one by the coordinate that a UVTransform makes. With J
 * the inverse of its matrix, d/du' = d/du J00 + d/dv J10, and d/dv' = d/du J01 + d/dv J11.
 * Applies to tangents and slopes; `group` is GROUP_DU or GROUP_DV. */
Ref lower_uv_tangent(Lower *l, const Node *node, Ref du, Ref dv, Group group);

/* Returns a slot of any material, unconverted; `principled`: a Phong is converted to a
 * Principled. */
Ref lower_value_slot(Lower *l, const Node *material, bool principled, Slot slot, const Env *env);
/* Returns true if the material's surface model is Principled, not Phong. */
bool lower_is_principled(const Lower *l, const Node *material);
/* Values of a Phong from which a Principled is made: the queried slot itself, the specular color
 * (vec3) and the exponent. */
typedef struct {
    Ref own, specular, exponent;
} PhongSlots;
/* Converts a slot of a Phong that is mixed with a Principled. Both have the same reflectance at
 * normal incidence, s 2 / (n + 2) for a specular color s and an exponent n, and the same lobe
 * width: roughness^4 = 2 / (n + 2). Ambient, diffuseTransparency and the transparency's lobe are
 * lost. n = 30 and s = (.8, .4, .4): reflectance .05, tint (1, .5, .5), roughness .5. */
Ref lower_principled_of_phong(Lower *l, Slot slot, const PhongSlots *phong);

/* Converts a slot of a Principled to a Phong, for a layout without the slot `model`, which
 * lights all materials as Phongs. With base color b, metalness m, reflectance F, tint t and
 * roughness r: exponent n = (1 / r^4 - 1) / 2; specular s = min(R (n + 2) / 2, 1), R = mix(F t,
 * b, m), of which 2 s / (n + 2) is reflected at normal incidence; diffuse b (1 - m) (1 - F) plus
 * the rest of R. Other slots are unchanged. b = 1, m = 0, F = .04, r = .6: n = 3.4, specular
 * .11, diffuse .96; r = .2: n = 312, specular 1, of .04 .0064, diffuse .994. */
Ref lower_phong_of_principled(Lower *l, const Node *material, Slot slot, const Env *env);

#define MAP(name, function, lowering, cost, doc)                                                   \
    MapValue lower_##name(Lower *l, const Node *node, Group group, const Env *env);
#include "grammar/maps.def"
/* Value of a material's slot; a normal has no unit length yet and is not flipped to the viewer's
 * side. */
#define DECLARE_SHADER(name)                                                                       \
    Ref lower_##name(Lower *l, const Node *material, Slot slot, const Env *env);
/* The material that a switch chooses for one side; NULL: missing. */
#define DECLARE_SWITCH(name)      const Node *lower_choose_##name(const Node *material, bool front);
#define DECLARE_FOREIGN(name)     /* translated: compiler/resolve/resolve_translation.c */
#define MATERIAL(name, sort, doc) DECLARE_##sort(name)
#include "grammar/materials.def"
#include "grammar/maps.def"
#undef DECLARE_SHADER
#undef DECLARE_SWITCH
#undef DECLARE_FOREIGN
#endif
