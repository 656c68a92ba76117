/* Creates IR nodes; a hash table finds existing equal nodes (hash-consing). */
#include "compiler/ir/ir.h"
#include <string.h>

const OpRow op_table[OP_COUNT] = {
#define OP(name, shape, glsl, arity, rule, doc)                                                    \
    {#name, SHAPE_##shape, glsl, arity, RULE_##rule, doc},
#include "grammar/ops.def"
};

static const char *const op_word[OP_COUNT] = {
#define PRINT(name, word) [OP_##name] = word,
#include "grammar/ops.def"
};

const char *op_text(Op op) { return op_word[op] ? op_word[op] : op_table[op].name; }

const uint8_t op_payload[OP_COUNT] = {
#define PAYLOAD(name, kind) [OP_##name] = PAYLOAD_##kind,
#include "grammar/ops.def"
};

/* capacity that is large enough for most formulas and small documents */
enum { FIRST_TABLE = 1024 };

Ir *ir_new(Session *session, const Graph *graph)
{
    Ir *ir = ARENA_NEW(session->arena, Ir);
    *ir = (Ir){.session = session, .arena = session->arena, .graph = graph};
    ir->table = ARENA_ARRAY(session->arena, Ref, FIRST_TABLE);
    ir->mask = FIRST_TABLE - 1;
    const IrNode none = {0};
    ARENA_PUSH(session->arena, ir->nodes, ir->count, ir->capacity,
               none); /* node 0 is the null node */
    return ir;
}

void ir_done(Ir *ir)
{
    arena_free(&ir->scratch);
    arena_free(&ir->kept);
    ir->ranges = NULL;
    ir->live = NULL;
}

static uint32_t mix_hash(uint32_t hash, uint32_t word)
{
    hash = (hash ^ word) * 0x9E3779B1u;
    return hash ^ hash >> 15;
}

/* Hashes and compares numbers by their bits: -0 differs from 0. */
static uint32_t hash_numbers(uint32_t hash, const double *numbers, int count)
{
    for (int i = 0; i < count; i++) {
        uint64_t bits;
        memcpy(&bits, &numbers[i], sizeof bits);
        hash = mix_hash(hash, (uint32_t)(bits ^ bits >> 32));
    }
    return hash;
}

static inline bool equal_numbers(const double *a, const double *b, int count)
{
    for (int i = 0; i < count; i++)
        if (memcmp(&a[i], &b[i], sizeof *a) != 0)
            return false;
    return true;
}

/* Probe sequence of a node. The first NEAR_SLOTS slots lie next to those of other users of its
 * youngest operand, so that nodes created together are neighbors in the cache. If they are
 * taken, or the node has no operand, probing continues from the slot of its hash. */
enum { NEAR_SLOTS = 8, NEAR_SPREAD = 15 };
typedef struct {
    uint32_t at, hash;
    uint32_t near; /* number of remaining near slots */
} Probe;

static inline Probe probe_of(const Ir *ir, const IrNode *node, const Ref *args)
{
    Ref youngest = 0;
    for (int i = 0; i < node->count; i++)
        youngest = args[i] > youngest ? args[i] : youngest;
    if (!youngest)
        return (Probe){node->hash & ir->mask, node->hash, 0};
    return (Probe){(2 * youngest + (node->hash & NEAR_SPREAD)) & ir->mask, node->hash, NEAR_SLOTS};
}

static inline void probe_next(const Ir *ir, Probe *probe)
{
    const bool leaves = probe->near == 1;
    probe->near -= probe->near > 0;
    probe->at = (leaves ? probe->hash : probe->at + 1) & ir->mask;
}

static void fill_table(Ir *ir)
{
    for (Ref ref = 1; ref < ir->count; ref++) {
        const IrNode *node = &ir->nodes[ref];
        Probe probe = probe_of(ir, node, node->count ? &ir->args[node->first] : NULL);
        while (ir->table[probe.at])
            probe_next(ir, &probe);
        ir->table[probe.at] = ref;
    }
}

static void grow_table(Ir *ir)
{
    ir->mask = 2 * ir->mask + 1;
    ir->table = ARENA_ARRAY(ir->arena, Ref, ir->mask + 1);
    fill_table(ir);
}

static uint32_t hash_node(const IrNode *node, const Ref *args)
{
    uint32_t hash = mix_hash(mix_hash(node->op, node->type), node->payload);
    for (int i = 0; i < node->count; i++)
        hash = mix_hash(hash, args[i]);
    return hash;
}

void ir_rehash(Ir *ir)
{
    ir->ranges = NULL;
    ir->live = NULL;
    ir->moved = true;
}

static void rehash(Ir *ir)
{
    ir->moved = false;
    for (Ref ref = 1; ref < ir->count; ref++) {
        IrNode *node = &ir->nodes[ref];
        if (node->op != OP_const) /* a constant is hashed by its numbers */
            node->hash = hash_node(node, node->count ? &ir->args[node->first] : NULL);
    }
    memset(ir->table, 0, sizeof(Ref) * (ir->mask + 1));
    fill_table(ir);
}

static Ref add_node(Ir *ir, const IrNode *node, uint32_t slot)
{
    Ref ref = (Ref)ir->count;
    ARENA_PUSH(ir->arena, ir->nodes, ir->count, ir->capacity, *node);
    ir->table[slot] = ref;
    if (2 * ir->count > ir->mask)
        grow_table(ir);
    return ref;
}

static inline bool equal_node(const Ir *ir, const IrNode *a, const IrNode *b, const Ref *args)
{
    if (a->hash != b->hash || a->op != b->op || a->type != b->type || a->count != b->count ||
        a->payload != b->payload)
        return false;
    const Ref *own = ir->args + a->first;
    for (int i = 0; i < b->count; i++)
        if (own[i] != args[i])
            return false;
    return true;
}

static Ref find_or_add(Ir *ir, IrNode *node, const Ref *args)
{
    if (ir->moved)
        rehash(ir);
    Probe probe = probe_of(ir, node, args);
    for (; ir->table[probe.at]; probe_next(ir, &probe))
        if (equal_node(ir, &ir->nodes[ir->table[probe.at]], node, args))
            return ir->table[probe.at];
    node->first = (uint32_t)ir->arg_count;
    node->origin = ir->origin;
    while (ir->arg_count + node->count > ir->arg_capacity)
        ir->args =
            arena_grow(ir->arena, ir->args, ir->arg_capacity, &ir->arg_capacity, sizeof *ir->args);
    for (int i = 0; i < node->count; i++)
        ir->args[ir->arg_count++] = args[i];
    return add_node(ir, node, probe.at);
}

Ref ir_const(Ir *ir, Type type, const double *numbers)
{
    const int components = type_table[type].components;
    if (ir->moved)
        rehash(ir);
    IrNode node = {.op = OP_const, .type = (uint8_t)type, .flags = NODE_simple | NODE_final};
    node.hash = hash_numbers(mix_hash(OP_const, type), numbers, components);
    uint32_t at = node.hash & ir->mask;
    for (; ir->table[at]; at = (at + 1) & ir->mask) {
        const IrNode *other = &ir->nodes[ir->table[at]];
        if (other->hash == node.hash && other->op == OP_const && other->type == type &&
            equal_numbers(&ir->numbers[other->payload], numbers, components))
            return ir->table[at];
    }
    node.payload = (uint32_t)ir->number_count;
    node.origin = ir->origin;
    /* `numbers` may point into ir->numbers; the arena keeps the old array when the list grows. */
    for (int i = 0; i < components; i++)
        ARENA_PUSH(ir->arena, ir->numbers, ir->number_count, ir->number_capacity, numbers[i]);
    return add_node(ir, &node, at);
}

static Type widest(const Ir *ir, const Ref *args, int count)
{
    Type type = ir_type(ir, args[0]);
    for (int i = 1; i < count; i++)
        if (ir_components(ir, args[i]) > type_table[type].components)
            type = ir_type(ir, args[i]);
    return type;
}

static Type type_by_rule(const Ir *ir, const IrNode *node, const Ref *args)
{
    switch (op_table[node->op].rule) {
    case RULE_widest:
        return widest(ir, args, node->count);
    case RULE_boolean:
        return TYPE_bool;
    case RULE_scalar:
        return TYPE_float;
    case RULE_first:
        return ir_type(ir, args[0]);
    default:
        return (Type)node->type;
    }
}

Ref ir_make(Ir *ir, IrNode made, const Ref *args)
{
    made.type = (uint8_t)type_by_rule(ir, &made, args);
    made.flags = made.count ? 0 : NODE_simple | NODE_final;
    made.hash = hash_node(&made, args);
    Ref ref = find_or_add(ir, &made, args);
    return ir->simplify && !(ir->nodes[ref].flags & NODE_simple) ? ir->simplify(ir, ref) : ref;
}

bool ir_is_number(const Ir *ir, Ref ref, double value)
{
    if (!ir_is(ir, ref, OP_const))
        return false;
    for (int i = 0; i < ir_components(ir, ref); i++)
        if (!(ir_numbers(ir, ref)[i] == value))
            return false;
    return true;
}

void ir_arguments(Ir *ir, int set, const Type *types, int count, Ref *arguments)
{
    enum { SET_SHIFT = 8 };
    for (int i = 0; i < count; i++)
        arguments[i] = ir_make(ir,
                               (IrNode){.op = OP_argument,
                                        .type = types[i],
                                        .payload = (uint32_t)set << SET_SHIFT | (uint32_t)i},
                               NULL);
}

static int *function_of(Ir *ir, Ref result)
{
    if (result >= ir->function_of_capacity) {
        size_t more = 2 * (size_t)result + 64;
        int *grown = ARENA_ARRAY(ir->arena, int, more);
        if (ir->function_of_capacity)
            memcpy(grown, ir->function_of, ir->function_of_capacity * sizeof *grown);
        ir->function_of = grown;
        ir->function_of_capacity = more;
    }
    return &ir->function_of[result];
}

int ir_function(Ir *ir, const Ref *arguments, int count, Ref result)
{
    int *last = function_of(ir, result);
    for (int f = *last; f; f = ir->functions[f - 1].next)
        if (ir->functions[f - 1].count == count &&
            !memcmp(ir->functions[f - 1].arguments, arguments, (size_t)count * sizeof *arguments))
            return f - 1;
    IrFunction function = {result, ARENA_ARRAY(ir->arena, Ref, count), count, ir->origin, *last};
    for (int i = 0; i < count; i++)
        function.arguments[i] = arguments[i];
    ARENA_PUSH(ir->arena, ir->functions, ir->function_count, ir->function_capacity, function);
    *last = (int)ir->function_count;
    return *last - 1;
}

void ir_output(Ir *ir, OutputKind kind, int index, Ref value)
{
    ir->outputs[ir->output_count++] = (IrOutput){kind, index, value};
    ir->live = NULL;
}

const IrOutput *ir_output_of(const Ir *ir, OutputKind kind)
{
    for (int i = 0; i < ir->output_count; i++)
        if (ir->outputs[i].kind == kind)
            return &ir->outputs[i];
    return NULL;
}

bool ir_is_of_fragments(const IrOutput *output)
{
    return output->kind != OUT_displacement && output->kind != OUT_normal;
}

/* Operands precede their users, and a function's result precedes its calls: one downward sweep
 * is enough. */
void ir_live_below(const Ir *ir, uint8_t *live, Ref last)
{
    for (Ref ref = last; ref > 0; ref--) {
        const IrNode *node = &ir->nodes[ref];
        if (!live[ref])
            continue;
        for (int i = 0; i < node->count; i++)
            live[ir->args[node->first + (uint32_t)i]] = 1;
        /* ir_check calls this before it has checked payloads */
        if (ir_applies(ir, ref) && node->payload < ir->function_count)
            live[ir->functions[node->payload].result] = 1;
    }
    live[0] = 0;
}

uint8_t *ir_live(const Ir *ir, Arena *arena)
{
    uint8_t *live = ARENA_ARRAY(arena, uint8_t, ir->count);
    for (int i = 0; i < ir->output_count; i++)
        live[ir->outputs[i].value] = 1;
    ir_live_below(ir, live, (Ref)ir->count - 1);
    return live;
}

const uint8_t *ir_live_kept(Ir *ir)
{
    if (!ir->live || ir->live_count != ir->count) {
        ir->live = ir_live(ir, &ir->kept);
        ir->live_count = ir->count;
    }
    return ir->live;
}

int ir_cost(const Ir *ir, Ref ref)
{
    const IrNode *node = &ir->nodes[ref];
    const int components = type_table[node->type].components;
    switch (node->op) {
#define operand_components ir_components(ir, ir_arg(ir, ref, 0))
#define COST(name, count)                                                                          \
    case OP_##name:                                                                                \
        return count;
#include "grammar/ops.def"
#undef operand_components
    default:
        return components;
    }
}

/* Returns the cost of the function that a node runs, from the costs of single runs. */
static double applied_cost(const Ir *ir, Ref ref, const double *cost)
{
    if (!ir_applies(ir, ref))
        return 0;
    return cost[ir_at(ir, ref)->payload] * (ir_is(ir, ref, OP_kernel) ? KERNEL_POINTS : 1);
}

/* Computes the cost of one run of each function, nested calls included; functions precede their
 * callers. */
static void function_costs(const Ir *ir, Arena *arena, double *cost)
{
    IrReach reach = ir_reach_new(ir, arena);
    for (size_t f = 0; f < ir->function_count; f++) {
        ir_reach(ir, &ir->functions[f].result, 1, &reach);
        cost[f] = 0;
        for (size_t i = 0; i < reach.count; i++)
            cost[f] += ir_cost(ir, reach.at[i]) + applied_cost(ir, reach.at[i], cost);
    }
}

void ir_measure(const Ir *ir, int *nodes, int *cost)
{
    Arena scratch = {0};
    double *function_cost = ARENA_ARRAY(&scratch, double, ir->function_count + 1), total = 0;
    function_costs(ir, &scratch, function_cost);
    uint8_t *live = ir_live(ir, &scratch);
    uint8_t *main_live = ir->function_count ? ARENA_ARRAY(&scratch, uint8_t, ir->count) : live;
    for (int i = 0; i < ir->output_count; i++)
        main_live[ir->outputs[i].value] = 1;
    *nodes = 0;
    for (Ref ref = (Ref)ir->count - 1; ref > 0; ref--) {
        *nodes += live[ref];
        if (!main_live[ref])
            continue;
        total += ir_cost(ir, ref) + applied_cost(ir, ref, function_cost);
        for (int i = 0; main_live != live && i < ir_at(ir, ref)->count; i++)
            main_live[ir_arg(ir, ref, i)] = 1;
    }
    *cost = total > INT32_MAX ? INT32_MAX : (int)total;
    arena_free(&scratch);
}
