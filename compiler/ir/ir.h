/* The IR: a typed DAG. Equal nodes are one node (hash-consing), so a common subexpression never
 * exists twice. Operands come before their users: node numbers are a topological order, and a sweep
 * over them meets operands first. */
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
extern const OpRow op_table[]; /* OP_COUNT rows; no object but ir.c's needs to know how many */
const char *op_text(Op op);    /* in the text of the IR */

/* Meaning of a node's `payload`, by operation. */
typedef enum {
    /* but of a select, 1: it is a guard, whose last operand nobody reads; build_guard */
    PAYLOAD_none,
    PAYLOAD_numbers,   /* the first of its numbers */
    PAYLOAD_input,     /* an Input */
    PAYLOAD_attribute, /* 3 times the graph's, by index, and which: AttributePart */
    PAYLOAD_uniform,   /* the graph's, by index */
    PAYLOAD_member,    /* the IR's, by index */
    PAYLOAD_argument,  /* whose set << 8 | its number */
    PAYLOAD_texture,   /* the IR's, by index */
    PAYLOAD_lanes,     /* two bits each */
    PAYLOAD_library,   /* a Function */
    PAYLOAD_function   /* of the program, by index; ir_applies */
} Payload;
extern const uint8_t op_payload[]; /* Payload, of each operation */

/* Parts of an attribute: its value, and its change to the next pixel. */
typedef enum { ATTRIBUTE_value, ATTRIBUTE_by_x, ATTRIBUTE_by_y, ATTRIBUTE_PARTS } AttributePart;
static inline uint32_t attribute_of(uint32_t payload) { return payload / ATTRIBUTE_PARTS; }
static inline AttributePart attribute_part(uint32_t payload)
{
    return (AttributePart)(payload % ATTRIBUTE_PARTS);
}

/* Origin of a node: the surface point that a pass starts from, a slot, or a map, by its number in
 * Ir.maps. Only names and comments depend on it: equal nodes are one node, which keeps its first
 * origin. */
enum { ORIGIN_SURFACE, ORIGIN_SLOTS, ORIGIN_MAPS = ORIGIN_SLOTS + SLOT_COUNT };

typedef uint32_t Ref; /* number of a node; 0 is none */

/* Flags of a node. Equal nodes are one node whatever their flags are. */
enum {
    /* it is the value of its origin's map or slot, not a step on the way; for names only */
    NODE_head = 1,
    /* no local rule changes it as long as nobody knows who uses it: opt_simplify was asked */
    NODE_simple = 2,
    NODE_final = 4,  /* none does, whoever uses it */
    NODE_decided = 8 /* no interval decides it: opt_range was asked */
};

typedef struct {
    uint8_t op, type, count; /* Op, Type, operands */
    uint8_t flags;           /* NODE_ */
    uint32_t origin;         /* what it was made for; for names and comments only */
    uint32_t first;          /* of its operands in args */
    uint32_t payload;        /* what op_payload says */
    uint32_t hash;
} IrNode;

/* A function of the program: a result that depends on arguments. Filters call one many times. */
typedef struct {
    Ref result;
    Ref *arguments; /* OP_argument nodes, in order */
    int count;
    uint32_t origin; /* what it was made for */
    /* the one with this result that was made before, from 1; 0 is none. By ir_function alone */
    int next;
} IrFunction;

/* OUT_displacement: how far the vertex stages move the point, a float along the normal, or a vec3
 * along dP/du, dP/dv and the normal; or a vec4, from where to where along the normal a volume is
 * solid, twice. OUT_normal: the unit normal of what it comes to be, of a compute program alone. */
typedef enum { OUT_discard, OUT_depth, OUT_color, OUT_displacement, OUT_normal } OutputKind;
typedef struct {
    OutputKind kind;
    int index; /* of a colour output */
    Ref value;
} IrOutput;

typedef enum { TEXTURE_image, TEXTURE_carpenter } TextureKind;
typedef struct {
    TextureKind kind;
    const Image *image; /* of an image */
    const Node *node;   /* of a Carpenter */
    int width, height;
    bool sampled; /* by the sampler, with mipmaps; else texel by texel */
    /* of an image: red, green and blue are decoded, by the sampler or before it has them */
    bool srgb;
    bool floats;   /* of an image: it may have any number */
    Texels texels; /* what the program's texture holds */
    Word wrap;     /* what its sampler does beyond the edges: an Address of words.def */
} IrTexture;

/* A number that a program reads from a buffer, so that materials that differ in it share the
 * program. constants.c */
typedef struct {
    Type type;
    double numbers[4]; /* this material's */
    uint32_t origin;   /* as a node's */
    /* where in the document it stands; NULL: an expression of such, or a place */
    const Value *source;
    const char *name; /* in the shader; constants_finish gives name and offset */
    int member;       /* of MatcOptions, or -1 */
    int offset;       /* in the std140 block, in bytes */
} IrConstant;

/* Transparency as lowering alone can decide it. */
typedef enum { OPACITY_unknown, OPACITY_opaque, OPACITY_transparent, OPACITY_varying } Opacity;

enum { MOST_OUTPUTS = 32 }; /* render targets, or all slots, with discard and depth */
_Static_assert((int)MOST_OUTPUTS >= (int)SLOT_COUNT, "a value of every slot");

/* Returns the node that replaces a new one, or the node itself. */
struct Ir;
typedef Ref Simplify(struct Ir *ir, Ref ref);
typedef struct Ir {
    Session *session;
    Arena *arena;
    Arena scratch; /* of the sweep under way; reset by it, freed by ir_done */
    Arena kept;    /* of what is known from sweep to sweep; freed by ir_done */
    /* those that were found, while nodes keep their numbers; NULL: none. By opt_range alone */
    struct Ranges *ranges;
    /* by Ref, of live_count nodes: ir_live_kept; NULL: nobody asked since an output or a node
     * changed */
    uint8_t *live;
    size_t live_count;
    IrNode *nodes;
    size_t count, room;
    Ref *args;
    size_t arg_count, arg_room;
    double *numbers;
    size_t number_count, number_room;
    /* hash table of nodes, of its own kind: they hold their hashes, and nothing is asked as
     * often */
    Ref *table;
    uint32_t mask;
    bool moved; /* nodes were, or were changed: the table is built anew before it is asked */
    IrFunction *functions;
    size_t function_count, function_room;
    IrTexture *textures;
    size_t texture_count, texture_room;
    HashIndex texture_index; /* by their contents; lower_surface.c */
    IrConstant *constants;
    size_t constant_count, constant_room;
    HashIndex constant_index; /* by their sources */
    const Graph *graph;       /* for uniforms' names */
    IrOutput outputs[MOST_OUTPUTS];
    int output_count;
    Opacity opacity;
    int layout_case;       /* of what is packed, by number */
    const Node *displaced; /* the material that says how; NULL: the surface is as its mesh is */
    /* where all slots are outputs: those that a layout has to store, 1 << slot */
    unsigned slots;
    bool keep_pow;        /* powers stay calls of pow */
    ReferenceNoise noise; /* which the folder computes with */
    Ref *held;            /* operands of calls whose arguments are being made; REFS of build.h */
    size_t held_count, held_room;
    int *function_of; /* by Ref: the last function of that result, from 1; by ir_function alone */
    size_t function_of_room;
    const Node **maps; /* that nodes were made for; origin.c */
    size_t map_count, map_room;
    HashIndex map_index;
    uint32_t origin; /* given to new nodes */
    /* Simplifies each new node; NULL leaves nodes as written. */
    Simplify *simplify;
} Ir;

Ir *ir_new(Session *session, const Graph *graph);
/* Copies an IR, without its outputs, into the session's arena. Nodes that are added to the copy do
 * not appear in the original. ir_fork.c */
Ir *ir_fork(const Ir *ir, Session *session);
/* Gives back what passes worked with; the IR itself stays. */
void ir_done(Ir *ir);

static inline const IrNode *ir_at(const Ir *ir, Ref ref) { return &ir->nodes[ref]; }
static inline Ref ir_arg(const Ir *ir, Ref ref, int i)
{
    return ir->args[ir->nodes[ref].first + (uint32_t)i];
}
static inline Type ir_type(const Ir *ir, Ref ref) { return (Type)ir->nodes[ref].type; }
static inline int ir_lanes(const Ir *ir, Ref ref) { return type_table[ir->nodes[ref].type].lanes; }
static inline bool ir_is(const Ir *ir, Ref ref, Op op) { return ir->nodes[ref].op == op; }
/* The numbers of a constant. */
static inline const double *ir_numbers(const Ir *ir, Ref ref)
{
    return &ir->numbers[ir->nodes[ref].payload];
}
/* The numbers that a leaf has in this material, whether they stand in the program or come from a
 * buffer; NULL: it is neither. What is decided by them is part of the program's shape. */
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
/* It runs a function of the program, which its payload numbers. */
static inline bool ir_applies(const Ir *ir, Ref ref)
{
    return op_payload[ir->nodes[ref].op] == PAYLOAD_function;
}
/* It takes differences between neighbouring pixels, which must all come by: it stands in no
 * branch. */
static inline bool ir_needs_neighbours(const Ir *ir, Ref ref)
{
    return ir_is(ir, ref, OP_call) && (ir_at(ir, ref)->payload == FN_imageSampled ||
                                       ir_at(ir, ref)->payload == FN_imageCentred);
}
/* A constant all of whose lanes are `value`. */
bool ir_is_number(const Ir *ir, Ref ref, double value);

/* Makes a node, or finds the equal one, or what `simplify` knows to stand for it. Of `made` are its
 * op, count and payload, and its type, unless op_table's rule gives that. build.h has words for
 * it. */
Ref ir_make(Ir *ir, IrNode made, const Ref *args);
Ref ir_const(Ir *ir, Type type, const double *numbers);
/* A number from the buffer. Equal sources are one; without a source each is its own. constants.c */
Ref ir_constant(Ir *ir, Type type, const double *numbers, const Value *source);
/* Arguments of a function to be; then, when its result is made, the function, or the equal one that
 * exists already. Functions that it calls come before it, and have arguments of another set. */
void ir_arguments(Ir *ir, int set, const Type *types, int count, Ref *arguments);
int ir_function(Ir *ir, const Ref *arguments, int count, Ref result);
void ir_output(Ir *ir, OutputKind kind, int index, Ref value);
/* The output of that kind, one of those that there is one of; NULL: there is none. */
const IrOutput *ir_output_of(const Ir *ir, OutputKind kind);
/* The fragment program writes it; others are the vertex stages'. */
bool ir_is_of_fragments(const IrOutput *output);
enum { KERNEL_POINTS = 27 }; /* of a function that a kernel sums */

/* Nodes moved or were changed: the hash table is built anew when the next one is made, which may be
 * never. */
void ir_rehash(Ir *ir);
/* Marks the nodes that the outputs reach, through functions too: live[ref]. */
uint8_t *ir_live(const Ir *ir, Arena *arena);
/* Live nodes, cached until an output or a node changes. */
const uint8_t *ir_live_kept(Ir *ir);
/* Marks what marked ones reach, of which `last` is the last. */
void ir_live_below(const Ir *ir, uint8_t *live, Ref last);
/* One sweep over the live nodes, operands first: each is remade on its new operands and given to
 * `rewrite`, which returns what stands for it, or the node itself. Whether anything changed. */
typedef Ref IrRewrite(Ir *ir, Ref ref, const void *user);
bool ir_sweep(Ir *ir, IrRewrite *rewrite, const void *user);
/* Sweeps as ir_sweep does, but leaves out nodes with the flag `settled`, which `rewrite` would not
 * change. 0: none are left out. */
bool ir_sweep_unsettled(Ir *ir, uint8_t settled, IrRewrite *rewrite, const void *user);
/* Nodes that some roots reach, without the functions that are run: users before operands. One
 * object is reused for many roots. */
typedef struct {
    Arena *arena;
    Ref *at;
    size_t count, room;
    uint8_t *inside; /* by Ref */
} IrReach;
IrReach ir_reach_new(const Ir *ir, Arena *arena);
void ir_reach(const Ir *ir, const Ref *roots, int count, IrReach *reach);
/* Nodes of main and of all functions together, each counted in every one that it stands in; at most
 * `limit` + 1. */
size_t ir_written(const Ir *ir, size_t limit);
/* Scalar operations of one node. */
int ir_cost(const Ir *ir, Ref ref);
/* Nodes alive, and their cost. */
void ir_measure(const Ir *ir, int *nodes, int *cost);
/* Invariants: operands before users, types by the rules, arguments only in functions that have
 * them. NULL, or what is wrong. */
const char *ir_check(const Ir *ir);

void ir_print(Text *out, const Ir *ir);
void ir_dot(Text *out, const Ir *ir);
/* Reads what ir_print wrote (tests); NULL and a message. Textures and uniforms are those of
 * `graph`. */
Ir *ir_read(Session *session, const char *text, const Graph *graph, const char **fault);

/* The origin of what a map makes; the map of an origin, NULL where it is none. origin.c */
uint32_t ir_origin(Ir *ir, const Node *map);
static inline const Node *ir_origin_map(const Ir *ir, uint32_t origin)
{
    return origin < ORIGIN_MAPS ? NULL : ir->maps[origin - ORIGIN_MAPS];
}
/* An identifier for it: "clay" by the author's own word, "diffuse_blend" where there is none,
 * "normal" of a slot. */
const char *ir_origin_name(Arena *arena, const Ir *ir, uint32_t origin);
/* A map in a comment: the author's word, or its kind. */
const char *ir_origin_title(const Node *map);

/* fold.c: one lane of an operation that works by lane; false when it is not finite. */
bool fold_lane(Op op, const double *args, double *result);
/* The value of a node on these operands, if they are constants; false when it has none (a texture,
 * an input). */
bool fold_node(const Ir *ir, const IrNode *node, const Ref *args, double *result);
#endif
