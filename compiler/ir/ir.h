/* The IR: a typed DAG. Equal nodes are one node (hash-consing), so common subexpressions are
 * eliminated by construction. Operands precede their users: node numbers are a topological
 * order, and a sweep in numeric order visits operands first. */
#ifndef MATC_IR_H
#define MATC_IR_H
#include "compiler/base/session.h"
#include "compiler/graph/graph.h"
#include "compiler/ir/job.h"
#include "compiler/library/reference.h"

typedef enum {
#define OP(name, shape, glsl, arity, rule, doc) OP_##name,
#include "grammar/ops.def"
    OP_COUNT
} Op;
typedef enum { SHAPE_special, SHAPE_infix, SHAPE_prefix, SHAPE_call } Shape;
typedef enum { RULE_given, RULE_widest, RULE_boolean, RULE_scalar, RULE_first } TypeRule;
typedef struct {
    const char *name;
    Shape shape;
    const char *glsl;
    int arity;
    TypeRule rule;
    const char *doc;
} OpRow;
extern const OpRow op_table[]; /* OP_COUNT rows, whose number only ir.c needs */
const char *op_text(Op op);    /* name of the operation in the text of the IR */

/* Meaning of a node's `payload`, per operation. */
typedef enum {
    /* No payload. Exception: a select with payload 1 is a guard, whose last operand is never
     * read: build_guard. */
    PAYLOAD_none,
    PAYLOAD_numbers, /* index of the constant's first number */
    PAYLOAD_input,   /* an Input of inputs.def */
    /* ATTRIBUTE_PARTS times the attribute's index in the graph, plus an AttributePart */
    PAYLOAD_attribute,
    PAYLOAD_uniform,    /* index of a uniform in the graph */
    PAYLOAD_member,     /* index of a constant of the IR */
    PAYLOAD_argument,   /* argument of a function: argument set << 8 | index in the set */
    PAYLOAD_texture,    /* index of a texture of the IR */
    PAYLOAD_components, /* a swizzle, two bits per component */
    PAYLOAD_library,    /* a library Function */
    PAYLOAD_function    /* index of a program's function, which ir_applies() recognizes */
} Payload;
extern const uint8_t op_payload[]; /* the Payload kind of each operation */

/* Parts of an attribute: its value, and its screen-space derivatives. */
typedef enum { ATTRIBUTE_value, ATTRIBUTE_by_x, ATTRIBUTE_by_y, ATTRIBUTE_PARTS } AttributePart;
static inline uint32_t attribute_of(uint32_t payload) { return payload / ATTRIBUTE_PARTS; }
static inline AttributePart attribute_part(uint32_t payload)
{
    return (AttributePart)(payload % ATTRIBUTE_PARTS);
}

/* Origin of a node: the surface point at the start of a pass, a slot, or a map with its number
 * in Ir.maps. Only names and comments depend on the origin: equal nodes are one node, which
 * keeps its first origin. */
enum { ORIGIN_SURFACE, ORIGIN_SLOTS, ORIGIN_MAPS = ORIGIN_SLOTS + SLOT_COUNT };

typedef uint32_t Ref; /* number of a node; 0: null node */

/* Flags of a node. Hash-consing ignores the flags. */
enum {
    /* The node is the final value of its map or slot, not an intermediate one; for names only. */
    NODE_head = 1,
    /* opt_simplify found that no local rule changes the node while its users are unknown. */
    NODE_simple = 2,
    NODE_final = 4,  /* no rule changes the node, whatever its users */
    NODE_decided = 8 /* opt_range found that no interval decides the node */
};

typedef struct {
    uint8_t op, type, count; /* an Op, a Type, and the number of operands */
    uint8_t flags;           /* set of NODE_ flags */
    uint32_t origin;         /* map or slot that created the node; for names and comments only */
    uint32_t first;          /* index of the node's first operand in args */
    uint32_t payload;        /* number whose meaning op_payload[op] gives */
    uint32_t hash;
} IrNode;

/* A function of the program: a result that depends on arguments. Filters call a function many
 * times. */
typedef struct {
    Ref result;
    Ref *arguments; /* OP_argument nodes of the function, in order */
    int count;
    uint32_t origin; /* map or slot that created the function */
    /* The previous function with this result, counted from 1; 0: none. Used by ir_function only. */
    int next;
} IrFunction;

/* OUT_displacement: offset of the point in the vertex stages. It is a float along the normal, or
 * a vec3 along dP/du, dP/dv and the normal, or a vec4 with two ranges along the normal where a
 * volume is solid. OUT_normal: the unit normal of the displaced surface, in compute programs
 * only. */
typedef enum { OUT_discard, OUT_depth, OUT_color, OUT_displacement, OUT_normal } OutputKind;
typedef struct {
    OutputKind kind;
    int index; /* index of a color output */
    Ref value;
} IrOutput;

typedef enum { TEXTURE_image, TEXTURE_carpenter } TextureKind;
typedef struct {
    TextureKind kind;
    const Image *image; /* image of a TEXTURE_image */
    const Node *node;   /* map of a TEXTURE_carpenter */
    int width, height;
    bool sampled; /* read through a sampler with mipmaps; false: texel fetch */
    /* sRGB image: red, green and blue are decoded by the sampler or in advance. */
    bool srgb;
    bool floats;   /* image with unbounded values (floating point) */
    Texels texels; /* texel format of the program's texture */
    Keyword wrap;  /* address mode outside [0, 1]: an Address of words.def */
} IrTexture;

/* A number that a program reads from a uniform block, so that materials that differ in the
 * number share the program. constants.c */
typedef struct {
    Type type;
    double numbers[4]; /* values of the constant in this material */
    uint32_t origin;   /* map or slot that created the number, as IrNode.origin */
    /* The number's place in the document; NULL for hoisted expressions and literals. */
    const Value *source;
    const char *name; /* name in the shader; constants_finish sets name and offset */
    int member;       /* index of the member in MatcOptions; -1: not a member */
    int offset;       /* offset in the std140 block in bytes */
} IrConstant;

/* Transparency, as far as lowering can decide it. */
typedef enum { OPACITY_unknown, OPACITY_opaque, OPACITY_transparent, OPACITY_varying } Opacity;

enum { MAX_OUTPUTS = 32 }; /* max outputs: render targets, or all slots, plus discard and depth */
_Static_assert((int)MAX_OUTPUTS >= (int)SLOT_COUNT, "a value of every slot");

/* Returns the node that replaces a new node, or the node itself. */
struct Ir;
typedef Ref Simplify(struct Ir *ir, Ref ref);
typedef struct Ir {
    Session *session;
    Arena *arena;
    Arena scratch; /* memory of the current sweep, which resets the arena; freed by ir_done */
    Arena kept;    /* memory of analyses cached across sweeps; freed by ir_done */
    /* Intervals found so far, valid while nodes keep their numbers; NULL: none. Used by
     * opt_range only. */
    struct Ranges *ranges;
    /* Live flags by Ref, for live_count nodes: ir_live_kept(). NULL: not computed since the last
     * change of an output or a node. */
    uint8_t *live;
    size_t live_count;
    IrNode *nodes;
    size_t count, capacity;
    Ref *args;
    size_t arg_count, arg_capacity;
    double *numbers;
    size_t number_count, number_capacity;
    /* Hash table of nodes. Not a HashIndex: nodes hold their own hashes, and this is the most
     * used table. */
    Ref *table;
    uint32_t mask;
    bool moved; /* nodes have moved or changed: rebuild the table before its next use */
    IrFunction *functions;
    size_t function_count, function_capacity;
    IrTexture *textures;
    size_t texture_count, texture_capacity;
    HashIndex texture_index; /* finds textures by content; lower_surface.c */
    IrConstant *constants;
    size_t constant_count, constant_capacity;
    HashIndex constant_index; /* finds constants by their source */
    const Graph *graph;       /* supplies the names of uniforms */
    IrOutput outputs[MAX_OUTPUTS];
    int output_count;
    Opacity opacity;
    int layout_case;       /* number of the layout case that is packed */
    const Node *displaced; /* the material that displaces the surface; NULL: none */
    /* When all slots are outputs: the slots that a layout has to store, 1 << slot. */
    unsigned slots;
    bool keep_pow;        /* powers with integer exponents stay calls of pow */
    ReferenceNoise noise; /* noise variant that constant folding uses */
    Ref *held;            /* stack of the operands of nested builder calls: REFS of build.h */
    size_t held_count, held_capacity;
    /* per Ref: the last function with that result, from 1; used by ir_function only */
    int *function_of;
    size_t function_of_capacity;
    const Node **maps; /* maps that created nodes, indexed by origin; origin.c */
    size_t map_count, map_capacity;
    HashIndex map_index;
    uint32_t origin; /* origin that new nodes get */
    /* Simplifies each new node; NULL leaves nodes unchanged. */
    Simplify *simplify;
} Ir;

Ir *ir_new(Session *session, const Graph *graph);
/* Copies an IR without its outputs into the session's arena. Nodes added to the copy do not
 * appear in the original. ir_fork.c */
Ir *ir_fork(const Ir *ir, Session *session);
/* Frees the working memory of passes; the IR itself stays. */
void ir_done(Ir *ir);

static inline const IrNode *ir_at(const Ir *ir, Ref ref) { return &ir->nodes[ref]; }
static inline Ref ir_arg(const Ir *ir, Ref ref, int i)
{
    return ir->args[ir->nodes[ref].first + (uint32_t)i];
}
static inline Type ir_type(const Ir *ir, Ref ref) { return (Type)ir->nodes[ref].type; }
static inline int ir_components(const Ir *ir, Ref ref)
{
    return type_table[ir->nodes[ref].type].components;
}
static inline bool ir_is(const Ir *ir, Ref ref, Op op) { return ir->nodes[ref].op == op; }
/* Returns the numbers of a literal. */
static inline const double *ir_numbers(const Ir *ir, Ref ref)
{
    return &ir->numbers[ir->nodes[ref].payload];
}
/* Returns the numbers of a leaf in this material, either literals or constants of the uniform
 * block; NULL for other nodes. Decisions by these numbers become part of the program's shape. */
static inline const double *ir_known(const Ir *ir, Ref ref)
{
    return ir_is(ir, ref, OP_const)    ? ir_numbers(ir, ref)
           : ir_is(ir, ref, OP_member) ? ir->constants[ir->nodes[ref].payload].numbers
                                       : NULL;
}
static inline bool ir_is_head(const Ir *ir, Ref ref) { return ir->nodes[ref].flags & NODE_head; }
static inline void ir_set_head(Ir *ir, Ref ref, bool head)
{
    ir->nodes[ref].flags = (uint8_t)((ir->nodes[ref].flags & ~NODE_head) | (head ? NODE_head : 0));
}
/* Returns true for a node that runs a function of the program; the payload is the function's
 * index. */
static inline bool ir_applies(const Ir *ir, Ref ref)
{
    return op_payload[ir->nodes[ref].op] == PAYLOAD_function;
}
/* Returns true for a node that takes screen-space derivatives, which need uniform control flow:
 * the node must not be in a branch. */
static inline bool ir_needs_neighbours(const Ir *ir, Ref ref)
{
    return ir_is(ir, ref, OP_call) && (ir_at(ir, ref)->payload == FN_imageSampled ||
                                       ir_at(ir, ref)->payload == FN_imageCentred);
}
/* Returns true for a constant whose components all equal `value`. */
bool ir_is_number(const Ir *ir, Ref ref, double value);

/* Creates a node, finds an equal existing node, or returns the node to which it simplifies. The
 * caller sets op, count and payload of `made`, and the type if the rule of op_table does not
 * determine it. build.h has builders for most uses. */
Ref ir_make(Ir *ir, IrNode made, const Ref *args);
Ref ir_const(Ir *ir, Type type, const double *numbers);
/* Creates a constant of the uniform block. Equal sources share a constant; without a source each
 * call creates a new one. constants.c */
Ref ir_constant(Ir *ir, Type type, const double *numbers, const Value *source);
/* Declares a function: ir_arguments() creates its arguments. Once the result is built,
 * ir_function() returns the function's index, or that of an equal existing function. Called
 * functions precede their callers and have arguments of another set. */
void ir_arguments(Ir *ir, int set, const Type *types, int count, Ref *arguments);
int ir_function(Ir *ir, const Ref *arguments, int count, Ref result);
void ir_output(Ir *ir, OutputKind kind, int index, Ref value);
/* Returns the output of a kind that occurs at most once; NULL: absent. */
const IrOutput *ir_output_of(const Ir *ir, OutputKind kind);
/* Returns true for outputs of the fragment program; other outputs belong to the vertex stages. */
bool ir_is_of_fragments(const IrOutput *output);
enum { KERNEL_POINTS = 27 }; /* number of points that a kernel sums */

/* Marks the hash table as stale after nodes have moved or changed. The table is rebuilt when the
 * next node is created, which may never happen. */
void ir_rehash(Ir *ir);
/* Returns live[ref]: marks the nodes that the outputs reach, including those in functions. */
uint8_t *ir_live(const Ir *ir, Arena *arena);
/* Returns the live nodes, cached until an output or a node changes. */
const uint8_t *ir_live_kept(Ir *ir);
/* Extends the marks to all operands of marked nodes; `last` is the last marked node. */
void ir_live_below(const Ir *ir, uint8_t *live, Ref last);
/* Sweeps once over the live nodes, operands first. Each node is rebuilt on its new operands and
 * passed to `rewrite`, which returns the replacement or the node itself. Returns whether any
 * node changed. */
typedef Ref IrRewrite(Ir *ir, Ref ref, const void *user);
bool ir_sweep(Ir *ir, IrRewrite *rewrite, const void *user);
/* Sweeps like ir_sweep() but skips nodes with the flag `settled`, which `rewrite` would not
 * change. 0: skips none. */
bool ir_sweep_unsettled(Ir *ir, uint8_t settled, IrRewrite *rewrite, const void *user);
/* Nodes that a set of roots reaches, users before operands, excluding called functions. One
 * object can be reused for many roots. */
typedef struct {
    Arena *arena;
    Ref *at;
    size_t count, capacity;
    uint8_t *inside; /* per Ref: the node is in the list */
} IrReach;
IrReach ir_reach_new(const Ir *ir, Arena *arena);
void ir_reach(const Ir *ir, const Ref *roots, int count, IrReach *reach);
/* Counts the nodes of main and of all functions; a node in several functions counts in each.
 * Stops at `limit` + 1. */
size_t ir_written(const Ir *ir, size_t limit);
/* Returns the scalar operations of one node. */
int ir_cost(const Ir *ir, Ref ref);
/* Counts the live nodes and their cost. */
void ir_measure(const Ir *ir, int *nodes, int *cost);
/* Checks the invariants: operands precede users, types follow the rules, arguments occur only in
 * their own functions. Returns NULL or a fault. */
const char *ir_check(const Ir *ir);

void ir_print(Text *out, const Ir *ir);
void ir_dot(Text *out, const Ir *ir);
/* Parses the output of ir_print (for tests). Returns NULL and a fault on failure. Textures and
 * uniforms come from `graph`. */
Ir *ir_read(Session *session, const char *text, const Graph *graph, const char **fault);

/* Returns the origin of nodes that a map creates. ir_origin_map() is the inverse; NULL if the
 * origin is no map. origin.c */
uint32_t ir_origin(Ir *ir, const Node *map);
static inline const Node *ir_origin_map(const Ir *ir, uint32_t origin)
{
    return origin < ORIGIN_MAPS ? NULL : ir->maps[origin - ORIGIN_MAPS];
}
/* Returns an identifier for an origin: "clay" from the author's name, "diffuse_blend" for an
 * unnamed map, "normal" for a slot. */
const char *ir_origin_name(Arena *arena, const Ir *ir, uint32_t origin);
/* Returns a map's title for comments: the author's name, or its kind. */
const char *ir_origin_title(const Node *map);

/* Folds one component of an operation that works per component; false if the result is not
 * finite. fold.c */
bool fold_component(Op op, const double *args, double *result);
/* Folds a node over constant operands. Returns false if an operand is not constant or the node
 * has no constant value (a texture, an input). */
bool fold_node(const Ir *ir, const IrNode *node, const Ref *args, double *result);
#endif
