/* Constants in a uniform block: created from numbers of the document, hoisted out of
 * expressions, assigned to places, laid out.
 *
 *     scaleU: 8 and rotation: 0 are constants c1 and c2; a coordinate is u * (c1 * cos(c2))
 *     constants_hoist: c1 * cos(c2) depends on constants alone, so its value 8 becomes
 *         a constant c3
 *     the program reads u * c3, and neither c1 nor c2 is in the block */
#include "compiler/ir/constants.h"
#include "compiler/ir/build.h"
#include "compiler/ir/std140.h"
#include <float.h>
#include <math.h>
#include <string.h>

static uint32_t add_constant(Ir *ir, Type type, const double *numbers, const Value *source,
                             uint32_t origin)
{
    IrConstant constant = {.type = type, .origin = origin, .source = source, .member = -1};
    memcpy(constant.numbers, numbers, sizeof(double) * (size_t)type_table[type].components);
    ARENA_PUSH(ir->arena, ir->constants, ir->constant_count, ir->constant_capacity, constant);
    return (uint32_t)ir->constant_count - 1;
}

Ref ir_constant(Ir *ir, Type type, const double *numbers, const Value *source)
{
    const uint32_t hash = hash_pointer(source);
    for (HashProbe probe = hash_probe(&ir->constant_index, hash);
         source && hash_probe_next(&probe);)
        if (ir->constants[probe.number].source == source)
            return build_leaf(ir, OP_member, type, (int)probe.number);
    const uint32_t number = add_constant(ir, type, numbers, source, ir->origin);
    if (source)
        hash_index_add(ir->arena, &ir->constant_index, hash, number);
    return build_leaf(ir, OP_member, type, (int)number);
}

bool constant_storable(Type type)
{
    return (type >= TYPE_float && type <= TYPE_vec4) || type == TYPE_uint || type == TYPE_uvec4;
}

/* Constant folding: returns for every node computed from constants alone its value as a constant
 * node, 0 for other nodes. from_buffer[ref]: a member of the uniform block is among the
 * operands. */
static Ref *known_values(Ir *ir, uint8_t *from_buffer)
{
    Ref count = (Ref)ir->count, *known = ARENA_ARRAY(&ir->scratch, Ref, count), args[UINT8_MAX];
    for (Ref ref = 1; ref < count; ref++) {
        const IrNode node = *ir_at(ir, ref);
        double numbers[4];
        bool all = node.count > 0;
        for (int i = 0; i < node.count; i++) {
            args[i] = known[ir_arg(ir, ref, i)];
            all &= args[i] != 0;
            from_buffer[ref] |= from_buffer[ir_arg(ir, ref, i)];
        }
        if (node.op == OP_const)
            known[ref] = ref;
        else if (node.op == OP_member)
            known[ref] = ir_const(ir, (Type)node.type, ir->constants[node.payload].numbers);
        else if (all && from_buffer[ref] && fold_node(ir, &node, args, numbers))
            known[ref] = ir_const(ir, (Type)node.type, numbers);
        from_buffer[ref] |= node.op == OP_member;
    }
    return known;
}

/* Replaces a node that depends on constants alone by its value: as a new member of the uniform
 * block, or, if `as_member` is false, as a literal. */
static void become_constant(Ir *ir, Ref ref, Ref known, bool as_member)
{
    IrNode *node = &ir->nodes[ref];
    uint32_t origin = node->origin;
    double numbers[4];
    memcpy(numbers, ir_numbers(ir, known), sizeof(double) * (size_t)ir_components(ir, known));
    *node = *ir_at(ir, known);
    node->origin = origin;
    if (!as_member)
        return;
    node->op = OP_member;
    node->payload = add_constant(ir, (Type)node->type, numbers, NULL, origin);
}

/* Example: div(1, c) with c = 4 from the block is known to be 0.25. The node becomes a new
 * member c' = 0.25, and c is removed if no other node reads it; mul(x, div(1, c)) is then a
 * product without a division. The sweep starts at the outputs and stops at replaced nodes, whose
 * operands are no longer needed. */
void constants_hoist(Ir *ir)
{
    Ref count = (Ref)ir->count;
    int made = 0;
    if (!ir->constant_count)
        return;
    uint8_t *from_buffer = ARENA_ARRAY(&ir->scratch, uint8_t, count),
            *needed = ARENA_ARRAY(&ir->scratch, uint8_t, count);
    const Ref *known = known_values(ir, from_buffer);
    for (int i = 0; i < ir->output_count; i++)
        needed[ir->outputs[i].value] = 1;
    for (Ref ref = count - 1; ref > 0; ref--) {
        const IrNode *node = ir_at(ir, ref);
        if (!needed[ref])
            continue;
        if (known[ref] && from_buffer[ref] && constant_storable((Type)node->type)) {
            become_constant(ir, ref, known[ref], made++ < MAX_CONSTANTS);
            continue;
        }
        if (ir_applies(ir, ref))
            needed[ir->functions[node->payload].result] = 1;
        for (int i = 0; i < node->count; i++)
            needed[ir_arg(ir, ref, i)] = 1;
    }
    ir->live = NULL;
    arena_reset(&ir->scratch);
}

/* Shifts all nodes up by the number of new members, which come first because any node may use
 * them. */
static void make_capacity(Ir *ir, int count)
{
    const IrNode none = {0};
    for (int i = 0; i < count; i++)
        ARENA_PUSH(ir->arena, ir->nodes, ir->count, ir->capacity, none);
    memmove(ir->nodes + 1 + count, ir->nodes + 1,
            (ir->count - 1 - (size_t)count) * sizeof *ir->nodes);
    memset(ir->nodes + 1, 0, (size_t)count * sizeof *ir->nodes);
    for (size_t i = 0; i < ir->arg_count; i++)
        ir->args[i] += (Ref)count;
    for (size_t f = 0; f < ir->function_count; f++) {
        ir->functions[f].result += (Ref)count;
        /* copies the list, as functions may share it */
        Ref *moved = ARENA_ARRAY(ir->arena, Ref, ir->functions[f].count);
        for (int i = 0; i < ir->functions[f].count; i++)
            moved[i] = ir->functions[f].arguments[i] + (Ref)count;
        ir->functions[f].arguments = moved;
    }
    for (int i = 0; i < ir->output_count; i++)
        ir->outputs[i].value += (Ref)count;
    ir->live = NULL;
}

void constants_place(Ir *ir, const NumberPlace *places, const int *member, int count)
{
    int members = 0;
    for (int i = 0; i < count; i++)
        members = member[i] >= members ? member[i] + 1 : members;
    make_capacity(ir, members);
    for (int i = 0; i < count; i++) {
        if (member[i] < 0)
            continue;
        Ref value = places[i].value + (Ref)members,
            user = places[i].user ? places[i].user + (Ref)members : 0;
        Ref at = (Ref)member[i] + 1;
        IrNode *leaf = &ir->nodes[at];
        if (!leaf->op && !leaf->type) {
            uint32_t origin = user ? ir_at(ir, user)->origin : ir_at(ir, value)->origin;
            const double *numbers = ir_numbers(ir, value);
            *leaf = (IrNode){.op = OP_member, .type = ir_at(ir, value)->type, .origin = origin};
            leaf->payload = add_constant(ir, (Type)leaf->type, numbers, NULL, origin);
            ir->constants[leaf->payload].member = member[i];
        }
        if (user)
            ir->args[ir_at(ir, user)->first + (uint32_t)places[i].operand] = at;
        else
            ir->outputs[places[i].operand].value = at;
    }
}

/* Returns a unique name: "clay_constant", "clay_constant2". */
static const char *new_name(Ir *ir, const IrConstant *constant, FreshNames *names)
{
    Text wanted = text_new(ir->arena);
    text_format(&wanted, "%s_constant", ir_origin_name(ir->arena, ir, constant->origin));
    const char *name;
    do
        name = names_fresh(ir->arena, names, wanted.at);
    while (names_find(&ir->graph->uniform_names, name) >= 0);
    return name;
}

/* Orders members by decreasing width; each vec3 is followed by a scalar, which fills its
 * padding. */
static void order(const IrConstant *list, size_t count, size_t *to)
{
    static const int widths[] = {4, 3, 2, 1};
    size_t placed = 0, next_number = 0;
    for (int w = 0; w < 4; w++)
        for (size_t i = w == 3 ? next_number : 0; i < count; i++) {
            if (type_table[list[i].type].components != widths[w])
                continue;
            to[placed++] = i;
            while (widths[w] == 3 && next_number < count &&
                   type_table[list[next_number].type].components != 1)
                next_number++;
            if (widths[w] == 3 && next_number < count)
                to[placed++] = next_number++;
        }
}

/* Returns true for an unnamed Constant map, whose kind is no useful name. The member is then
 * named after its user. */
static bool is_nameless(const Ir *ir, const IrConstant *constant)
{
    const Node *map = ir_origin_map(ir, constant->origin);
    return map && map->kind == KIND_Constant && !map->name;
}

static void take_users_origins(const Ir *ir, const uint32_t *number, IrConstant *kept)
{
    for (Ref ref = 1; ref < ir->count; ref++)
        for (int i = 0; i < ir_at(ir, ref)->count; i++) {
            const IrNode *arg = ir_at(ir, ir_arg(ir, ref, i));
            if (arg->op == OP_member && is_nameless(ir, &kept[number[arg->payload] - 1]))
                kept[number[arg->payload] - 1].origin = ir_at(ir, ref)->origin;
        }
}

void constants_finish(Session *session, Ir *ir, const int *list, size_t count)
{
    int size = 0;
    FreshNames names = {0};
    /* numbered from 1, in the given order */
    uint32_t *number = ARENA_ARRAY(session->arena, uint32_t, ir->constant_count + 1);
    IrConstant *kept = ARENA_ARRAY(session->arena, IrConstant, ir->constant_count + 1);
    size_t *from = ARENA_ARRAY(session->arena, size_t, ir->constant_count + 1);
    for (size_t i = 0; i < count; i++) {
        kept[i] = ir->constants[list[i]];
        number[list[i]] = (uint32_t)i + 1;
    }
    take_users_origins(ir, number, kept);
    IrConstant *laid = ARENA_ARRAY(session->arena, IrConstant, count + 1);
    uint32_t *moved = ARENA_ARRAY(session->arena, uint32_t, count + 1);
    order(kept, count, from);
    for (size_t i = 0; i < count; i++) {
        laid[i] = kept[from[i]];
        laid[i].offset = std140_offset(type_table[laid[i].type].name, &size);
        moved[from[i]] = (uint32_t)i;
    }
    for (Ref ref = 1; ref < ir->count; ref++)
        if (ir_is(ir, ref, OP_member))
            ir->nodes[ref].payload = moved[number[ir->nodes[ref].payload] - 1];
    ir->constants = laid;
    ir->constant_count = count;
    for (size_t i = 0; i < count; i++)
        laid[i].name = new_name(ir, &laid[i], &names);
}

uint32_t constant_bits(double value, bool word)
{
    float number = (float)fmin(fmax(value, -FLT_MAX), FLT_MAX); /* rounds like text_float() */
    uint32_t bits;
    if (word)
        return (uint32_t)value;
    memcpy(&bits, &number, sizeof bits);
    return bits;
}

int constants_size(const Ir *ir)
{
    int size = 0;
    for (size_t i = 0; i < ir->constant_count; i++)
        std140_offset(type_table[ir->constants[i].type].name, &size);
    return std140_size(size);
}
