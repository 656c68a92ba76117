/* Graph -> Ir. A map is asked for a group of channels in an environment; what it does not define it
 * passes on to its input, and no input is the surface. */
#ifndef MATC_LOWER_H
#define MATC_LOWER_H
#include "compiler/lower/affine.h"

/* Values of the surface, where queries end. Filters evaluate their input in an environment of their
 * own. */
typedef struct {
    Ref root[GROUP_COUNT];
    Ref front; /* bool: seen from the front */
    bool seen; /* there is a viewer */
    /* of a displacement, which goes by places alone: attributes have their defaults, and the
     * object's random number is 0 */
    bool shape;
    Ref eye_n;  /* the root normal in eye space, 0 if only eyeFromWorld can tell */
    int number; /* for the memo: of how many filters it is the inside, and at which place; Place */
    /* for the memo too: within a displacement, whose slope by u and v is asked; relief.c */
    bool relief;
} Env;

/* Along what a value is differentiated: to the next pixel on the screen, and by the surface's own u
 * and v. */
typedef enum { DIRECTION_right, DIRECTION_up, DIRECTION_u, DIRECTION_v, DIRECTION_COUNT } Direction;

/* A map's value: with --aa its mean over the pixel, and what is known of its variation there. This
 * depends on the maps that were queried, never on nodes of the IR: where the builder merges two
 * values into one node, each keeps its own, and programs of all levels of -O antialias alike.
 * answer.h */
typedef struct {
    Ref value;
    /* within the pixel, by lane, that the mean's slope does not show; of the value's type; 0 for
     * none */
    Ref variance;
    const struct Split *split; /* NULL: it is not known to be one of two */
} Answer;

/* A value that is one of two all over the pixel: what is not linear has to be asked of both. */
typedef struct Split {
    Ref by; /* how much of the pixel has a's value; or a bool: whether all of it has */
    Answer a, b;
} Split;

typedef struct {
    uint64_t key; /* node, group, environment; 0 is empty */
    Answer answer;
    bool averaged; /* this map or one below it was averaged over the pixel */
} Memo;

/* The last result of lower_slot for a slot. */
typedef struct {
    const Node *material;
    int number;    /* of its environment */
    bool averaged; /* as in Memo */
    Ref value;     /* 0: not lowered yet */
} SlotAnswer;

typedef struct {
    Ref u, v;
} Slopes;

/* Transform of slopes by a chain of UVTransforms: the product of all. */
typedef struct {
    bool known;
    int count;             /* of transforms */
    const Node *transform; /* of one */
    Slopes column[2];      /* of several: what becomes of (1, 0) and of (0, 1) */
} Turn;

/* Where a Triplanar asks its maps: a texture coordinate, in an environment of that number. */
/* above LIMIT_FILTERS: an environment's number is PLACE_STRIDE places + filters */
enum { PLACE_STRIDE = 8 };
typedef struct {
    Ref uv;
    int outer;
} Place;

/* A map that --aa=auto may average, as lowering met it: asked for a group. */
typedef struct {
    const Node *map;
    Group group;
    bool outside; /* where the pass begins: not at a Triplanar's place, nor in a relief */
} MetMap;
typedef struct {
    MetMap *at;
    size_t count, room;
    bool mingled; /* with what else is computed: slopes and footprints that are asked for anyway */
} MapList;

/* How nodes are made. */
typedef struct {
    bool cheap;         /* forms that are cheaper but not the plainest: -O1 and up */
    Simplify *simplify; /* the local rules; NULL in the IR at -O0 */
} Manner;

typedef struct {
    Session *session;
    Ir *ir;
    const Graph *graph;
    Memo *memo;
    size_t memo_count, memo_mask;
    const Job *job;
    Simplify *simplify;  /* the local rules; NULL in the IR at -O0 */
    int filters;         /* under way: Smooth3D, Laplace3D */
    const Node *map;     /* under way */
    MapList averageable; /* with --aa=auto; budget.c */
    int averaged_below;  /* of these, maps of a lower index are averaged */
    bool averaged;       /* the map under way, or one below it, was averaged */
    /* under way: maps of a choice that is likely to become a branch */
    int arms;
    bool relief;                    /* under way: a displacement of --derivatives=auto; relief.c */
    Manner outside;                 /* of it */
    bool cheap;                     /* forms that are cheaper but not the plainest: -O1 and up */
    Ref (*slopes)[DIRECTION_COUNT]; /* by Ref: derivatives found so far; slope.c */
    size_t slope_room;
    struct LateSum **sums; /* by Ref: values whose derivatives are said as sums; slope_sum.c */
    size_t sum_room;
    Ref *to_differ; /* stack of values whose derivatives are under way; slope.c */
    size_t to_differ_count, to_differ_room;
    Place *places; /* of all Triplanars; lower_triplanar.c */
    size_t place_count, place_room;
    HashIndex place_index;
    Turn *turns; /* by node; lower_normal.c */
    size_t turn_room;
    SlotAnswer asked[SLOT_COUNT];
    struct SlotMemo *slots; /* by node and slot: what mixed materials answered; lower_material.c */
    Affine affine;          /* affine.c */
    unsigned layout_slots;  /* layout_slots() of the job's layout */
    uint8_t *uniform_use;   /* by uniform: 1 as a count, 2 as a number */
    /* Blends whose coordinates are to be looked at, the last first; lower_doubt.c */
    const struct Crossing *crossing;
    const struct Relief *reliefs; /* displacements whose slopes are, the last first */
    bool detached;                /* a footprint was asked for: it stands behind a mark */
    bool failed;                  /* a diagnostic was made */
} Lower;

/* The point of a rasterised surface. lower_pass.c */
Env lower_surface_env(Lower *l);
/* Lowers a material to the IR of a job's program. NULL: see the diagnostics. */
Ir *lower(Session *session, const Graph *graph, const Node *material, const Job *job,
          Simplify *simplify);

/* Arguments of lower(). */
typedef struct {
    Session *session;
    const Graph *graph;
    const Node *material;
    const Job *job;
    Simplify *simplify;
} LowerRequest;
/* Lowers with means for the maps below an index only, as --aa=auto does; optionally counts the maps
 * that could have one. lower_pass.c */
Ir *lower_averaging(Lower *l, const LowerRequest *what, int below);
/* Operations of the program without means, after `l` has lowered the program with means: values
 * that no mean is part of are reused. `l` cannot lower anything afterwards. Negative: failure.
 * lower_pass.c */
int lower_cost_of_points(const Lower *l, const Node *material);
/* A lowering of maps alone, and the environment that its pass begins with. lower_pass.c */
Lower lower_start(const LowerRequest *what, int optimize);
Env lower_pass_env(Lower *l);

/* Group of channels of a map; NULL is the surface. R has the type its map makes, IOR is a float,
 * the rest are vec3. */
Answer lower_answer(Lower *l, const Node *map, Group group, const Env *env);
/* Its value. */
Ref lower_ask(Lower *l, const Node *map, Group group, const Env *env);
/* Estimate from the cost tables: operations of a map or material without means, counted up to
 * `limit`, and the number of its maps that may be averaged. */
typedef struct {
    int points, averageable;
} MapCosts;
MapCosts lower_map_costs(const Node *map, int limit);
bool lower_wants_branch(const Node *map); /* it costs enough to be computed only where it shows */
/* lower_answer() for a map that is one of several to choose from: its evaluation may move into a
 * branch. */
Answer lower_arm(Lower *l, const Node *map, Group group, const Env *env);
void lower_mark_head(Ir *ir, Ref value, uint32_t origin);
/* A colour as another group's value: lane 0 for IOR, three lanes otherwise. */
Ref lower_as_group(Lower *l, Ref value, Group group);
/* A parameter's value as IR, converted to the type. */
Ref lower_param(Lower *l, const Value *value, Type type);
/* The map in a parameter, NULL if it has none. */
const Node *lower_param_node(const Node *node, int param);
/* Reports a param where the value must be known. */
void lower_reject_uniform(Lower *l, const Value *value, const char *name, const char *why);
/* Cost of a value, up to `limit`: an upper bound, as shared parts count as often as they are met.
 * lower_cost.c */
int lower_cost_below(const Ir *ir, Ref ref, int limit);
/* One material slot, by its name. lower_material.c */
Ref lower_slot(Lower *l, const Node *material, Slot slot, const Env *env);
/* The material whose parameters displace a surface: itself, or through its switches that which
 * stands for it, of a SideSwitch in front; NULL: none. lower_material.c */
const Node *lower_displaced(const Node *material);
/* Displacement of a point (lower_displacement.c): a float along the normal, or a vec3 along dP/du,
 * dP/dv and the normal; for a volume a vec4, the two intervals along the normal that are solid. */
Ref lower_displacement(Lower *l, const Node *displaced, const Env *env);
/* The surface after it was displaced: its normal and tangents, by the slopes of what displaces it;
 * the rest of `env` as it was. */
Env lower_displaced_env(Lower *l, const Node *displaced, const Env *env);
/* Writes displacement and slopes as colours; or for the vertex stages, where there are no
 * derivatives on the screen. `displaced` may be NULL. */
void lower_write_displacement(Lower *l, const Node *displaced, const Env *env);
void lower_displace_vertices(Lower *l, const Node *displaced);
/* The normal of a surface with these tangents that rose by slopes along `unit`, on the side of
 * tangents as the mesh has them. lower_normal.c */
typedef struct {
    Ref tu, tv; /* tangents, before they rise */
    Ref unit;   /* n / |n|; 0 where that has no length */
    Ref flat;   /* the cross product whose side counts; 0: that of tu and tv */
} Frame;
Ref lower_raised_normal(Lower *l, const Frame *f, const Ref slope[2]);
/* n / |n|; 0 where that has no length. */
Ref lower_unit(Lower *l, Ref n);
/* How that changes where n does: by what of the change is across n, over |n|. n = (0, 0, 2) and a
 * change of (1, 0, 1): (.5, 0, 0). */
Ref lower_unit_slope(Lower *l, Ref n, Ref change);

/* The parameters of a coat: of a Principled, or of a Layer. lower_coat.c */
typedef struct {
    const Node *of;
    int weight, color, roughness, ior, darkening, roughening, normal;
} Coat;
#define COAT_OF(node, kind)                                                                        \
    {                                                                                              \
        node, P_##kind##_coat, P_##kind##_coatColor, P_##kind##_coatRoughness, P_##kind##_coatIor, \
            P_##kind##_coatDarkening, P_##kind##_coatRoughening, P_##kind##_coatNormal             \
    }
/* One of its slots, over a base of that diffuse colour. */
Ref lower_coat_slot(Lower *l, const Coat *coat, Slot slot, Ref diffuse, const Env *env);
/* Its normal, a direction, where its weight is above 0; nothing where it has that of the base. */
Ref lower_coat_normal(Lower *l, const Coat *coat, const Env *env);
/* The surface below a coat: its apparent roughness, its reflectance along the normal, its index of
 * refraction relative to that of air, and its emission. */
Ref lower_coated_roughness(Lower *l, const Coat *coat, Ref roughness, const Env *env);
Ref lower_coated_reflectance(Lower *l, const Coat *coat, Ref ior, const Env *env);
Ref lower_coated_emission(Lower *l, const Coat *coat, Ref sent, const Env *env);
/* Index of refraction of a film below a coat, in its slot's range. */
Ref lower_coated_film(Lower *l, const Coat *coat, Ref ior, const Env *env);
Ref lower_film_ior(Ir *ir, Ref ior);
/* A slot of a lobe, absent where its weight is not above 0. */
Ref lower_where_there(Ir *ir, Ref weight, Slot slot, Ref value);
/* ((ior - 1) / (ior + 1))^2 */
Ref lower_reflectance(Ir *ir, Ref ior);

/* The shading normal as a G-buffer holds it, of eye space or the world, unit length, turned to the
 * viewer. */
Ref lower_stored_normal(Lower *l, const Node *material, const Env *env);
/* The coat's own, the same, or nothing. */
Ref lower_stored_coat_normal(Lower *l, const Node *material, const Env *env);
/* The slot anisotropy about that normal. lower_principled.c */
Ref lower_stored_anisotropy(Lower *l, const Node *material, const Env *env);
/* Writes every render target of the job's layout, by that case of it. lower_layout.c */
void lower_layout(Lower *l, int number, const Node *material, const Env *env);
/* The case of the layout that the material takes; their number: none stores all that it has. The IR
 * must simplify, so that constants are seen. */
int lower_layout_case(Lower *l, const Node *material, const Env *env);
/* The case that loses the fewest slots, which is said; their number: the layout is not for
 * everything, or none knows the model. */
int lower_nearest_case(Lower *l, const Node *material, const Env *env);
/* A warning about what no case of a layout for all Principled materials has room for. */
void lower_left_out(Lower *l, const Node *material, const Env *env);
/* Says that there is none. */
void lower_no_case(Lower *l, const Node *material, const Env *env);
/* The slots that a case of a layout made for a set must store for the material to take it, 1 <<
 * slot; alpha is in the transparency. */
unsigned lower_needed_slots(Lower *l, const Node *material, const Env *env);
/* Remembers the coordinate of a Blend with items, and the slopes of a displacement (0: none).
 * lower_doubt.c */
void lower_note_crossing(Lower *l, const Node *blend, Ref coordinate);
void lower_note_relief(Lower *l, const Node *displacement, Ref by_u, Ref by_v);
/* When all is lowered: warns of those that never reach their items, and of those that are 0. */
void lower_doubt(Lower *l);
Answer lower_wave(Lower *l, const Wave *wave, Answer v);
/* w(frequency f + phase), w the node's wave, whose first four parameters are those of
 * VOLUME_PARAMS. */
Answer lower_waved(Lower *l, const Node *node, Answer f);
/* Derivatives by u and v -> the one by the coordinate that a UVTransform makes: with J the inverse
 * of its matrix, d/du' = d/du J00 + d/dv J10, d/dv' likewise. Tangents or slopes; GROUP_DU or
 * GROUP_DV. */
Ref lower_uv_tangent(Lower *l, const Node *node, Ref du, Ref dv, Group group);

/* A slot of any material, as its map makes it; `principled`: what is a Phong becomes a
 * Principled. */
Ref lower_value_slot(Lower *l, const Node *material, bool principled, Slot slot, const Env *env);
/* The surface model of a material. */
bool lower_is_principled(const Lower *l, const Node *material);
/* Values of a Phong that a Principled is made of: the slot itself, the specular color (vec3) and
 * its exponent. */
typedef struct {
    Ref own, specular, exponent;
} PhongSlots;
/* The Principled that stands for a Phong beside another Principled in a Mix. Along the normal both
 * reflect as much, s 2 / (n + 2) of a specular colour s and an exponent n, and as wide: roughness^4
 * = 2 / (n + 2). Ambient, diffuseTransparency and what goes with transparency are lost. n = 30 and
 * s = (.8, .4, .4): reflectance .05, tint (1, .5, .5), roughness .5. */
Ref lower_principled_of_phong(Lower *l, Slot slot, const PhongSlots *phong);

/* The Phong that stands for a Principled in a layout without the slot `model`, which lights all
 * as Phongs. With base color b, metalness m, reflectance F, tint t and roughness r: exponent n =
 * (1 / r^4 - 1) / 2; specular s = min(R (n + 2) / 2, 1), R = mix(F t, b, m), of which 2 s / (n +
 * 2) is reflected along the normal; diffuse b (1 - m) (1 - F) and the rest of R. Other slots are
 * as they are. b = 1, m = 0, F = .04, r = .6: n = 3.4, specular .11, diffuse .96; r = .2: n =
 * 312, specular 1, of .04 .0064, diffuse .994. */
Ref lower_phong_of_principled(Lower *l, const Node *material, Slot slot, const Env *env);

#define MAP(name, function, lowering, cost, doc)                                                   \
    Answer lower_##name(Lower *l, const Node *node, Group group, const Env *env);
#include "grammar/maps.def"
/* Value of a material's slot; a normal is not of unit length and not yet flipped to a side. */
#define DECLARE_SHADER(name)                                                                       \
    Ref lower_##name(Lower *l, const Node *material, Slot slot, const Env *env);
/* The material that a switch stands for, seen of one side; NULL: it is missing. */
#define DECLARE_SWITCH(name)      const Node *lower_choose_##name(const Node *material, bool front);
#define DECLARE_FOREIGN(name)     /* none is left: compiler/resolve/resolve_translation.c */
#define MATERIAL(name, sort, doc) DECLARE_##sort(name)
#include "grammar/materials.def"
#include "grammar/maps.def"
#undef DECLARE_SHADER
#undef DECLARE_SWITCH
#undef DECLARE_FOREIGN
#endif
