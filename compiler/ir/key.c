/* The structure of an IR as a list of words, and its hash. A node appends its operation, type
 * and payload, then a word for each operand: the operand's number in the walk, or the type of a
 * constant. Numbers are listed separately.
 *
 *     add(x, 2)    words: input x -- add, 1, a float --    numbers: 2
 *     add(x, 3)    same words, so one shape; other numbers, so two keys */
#include "compiler/ir/key.h"
#include <string.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

typedef struct {
    Arena *arena;
    const Ir *ir;
    uint32_t *words;
    size_t word_count, word_capacity;
    double *numbers;
    size_t number_count, number_capacity;
    NumberPlace *places;
    size_t place_count, place_capacity;
    uint32_t *number; /* per Ref: its number in post-order, from 1; 0: not visited */
    Ref *stack;
    size_t depth, stack_capacity;
    uint32_t met;
    int *members; /* constants of the uniform block in post-order */
    size_t member_count, member_capacity;
} Walk;

static void put(Walk *w, uint32_t word)
{
    ARENA_PUSH(w->arena, w->words, w->word_count, w->word_capacity, word);
}

static void put_text(Walk *w, const char *text)
{
    uint64_t hash = XXH3_64bits(text, strlen(text));
    put(w, (uint32_t)hash);
    put(w, (uint32_t)(hash >> 32));
}

/* Rounds a number as the program does: floats to float; integers stay exact. */
static double written(Type type, double value)
{
    return type >= TYPE_float && type <= TYPE_vec4 ? (double)(float)value : value;
}

static void put_fixed(Walk *w, double number)
{
    uint32_t halves[2];
    memcpy(halves, &number, sizeof halves);
    put(w, halves[0]);
    put(w, halves[1]);
}

/* Appends an operand: its number in the walk, or a constant. */
static void put_value(Walk *w, Ref value, bool placed)
{
    /* flag that distinguishes constants from all numbers of the walk */
    const uint32_t constant = 0x80000000u;
    const Ir *ir = w->ir;
    Type type = ir_type(ir, value);
    if (!ir_is(ir, value, OP_const)) {
        put(w, w->number[value]);
        return;
    }
    put(w, constant | (uint32_t)type);
    for (int i = 0; i < ir_components(ir, value); i++) {
        double number = written(type, ir_numbers(ir, value)[i]);
        if (placed)
            ARENA_PUSH(w->arena, w->numbers, w->number_count, w->number_capacity, number);
        else
            put_fixed(w, number);
    }
}

/* Appends an operand of a node, or an output's value. */
static void put_operand(Walk *w, Ref user, int operand, Ref value)
{
    bool placed = ir_is(w->ir, value, OP_const) && constant_storable(ir_type(w->ir, value));
    const NumberPlace place = {user, operand, value};
    if (placed)
        ARENA_PUSH(w->arena, w->places, w->place_count, w->place_capacity, place);
    put_value(w, value, placed);
}

/* Appends a texture's format and sampler; its image is not part of the key. */
static void put_texture(Walk *w, const IrTexture *texture)
{
    put(w, (uint32_t)texture->kind << 3 | (uint32_t)texture->floats << 2 |
               (uint32_t)texture->sampled << 1 | texture->srgb);
    put(w, (uint32_t)texture->texels << 8 | (uint32_t)texture->wrap);
}

static void put_payload(Walk *w, const IrNode *node)
{
    const Ir *ir = w->ir;
    switch ((Payload)op_payload[node->op]) {
    case PAYLOAD_attribute: /* the index is a vertex attribute location */
        put(w, node->payload);
        put_text(w, ir->graph->attributes[attribute_of(node->payload)]->name);
        break;
    case PAYLOAD_uniform:
        put_text(w, ir->graph->uniforms[node->payload]->name);
        break;
    case PAYLOAD_library:
        put_text(w, function_row((int)node->payload)->name);
        break;
    case PAYLOAD_member: /* members of the block are identified by their order in the walk */
        break;
    case PAYLOAD_texture:
        put(w, node->payload);
        if (node->payload < ir->texture_count)
            put_texture(w, &ir->textures[node->payload]);
        break;
    default:
        put(w, node->payload);
        break;
    }
}

static void leave(Walk *w, Ref ref)
{
    const IrNode *node = ir_at(w->ir, ref);
    w->number[ref] = ++w->met;
    put(w, (uint32_t)node->op << 16 | (uint32_t)node->type << 8 | node->count);
    put_payload(w, node);
    if (node->op == OP_member)
        ARENA_PUSH(w->arena, w->members, w->member_count, w->member_capacity, (int)node->payload);
    if (ir_applies(w->ir, ref)) {
        const IrFunction *function = &w->ir->functions[node->payload];
        put_value(w, function->result, false);
        put(w, (uint32_t)function->count);
    }
    for (int i = 0; i < node->count; i++)
        put_operand(w, ref, i, ir_arg(w->ir, ref, i));
}

static void push(Walk *w, Ref ref)
{
    if (!w->number[ref] && !ir_is(w->ir, ref, OP_const))
        ARENA_PUSH(w->arena, w->stack, w->depth, w->stack_capacity, ref);
}

/* Post-order walk, left operands before right ones. A node stays on the stack until all of its
 * operands are numbered. */
static void visit(Walk *w, Ref root)
{
    push(w, root);
    while (w->depth) {
        Ref ref = w->stack[w->depth - 1];
        size_t before = w->depth;
        if (w->number[ref]) {
            w->depth--;
            continue;
        }
        for (int i = ir_at(w->ir, ref)->count - 1; i >= 0; i--)
            push(w, ir_arg(w->ir, ref, i));
        if (ir_applies(w->ir, ref))
            push(w, w->ir->functions[ir_at(w->ir, ref)->payload].result);
        if (w->depth > before)
            continue;
        w->depth--;
        leave(w, ref);
    }
}

static void put_job(Walk *w, const Job *job, int optimize)
{
    put(w, (uint32_t)job->target << 16 | (uint32_t)job->pass << 8 | (uint32_t)job->origin << 3 |
               (uint32_t)job->moved << 2 | (uint32_t)job->instances << 1 | (optimize > 0));
    for (int axis = 0; axis < AXIS_COUNT; axis++) /* library files may exist in variants */
        put(w, axis_table[axis].chunks ? (uint32_t)job->choice[axis] : 0);
}

static Key key_of(XXH128_hash_t hash) { return (Key){hash.low64, hash.high64}; }

IrKey ir_key(Session *session, const Ir *ir, const Job *job)
{
    Arena scratch = {0};
    Walk w = {.arena = &scratch, .ir = ir, .number = ARENA_ARRAY(&scratch, uint32_t, ir->count)};
    put_text(&w, MATC_VERSION);
    put_job(&w, job, session->optimize);
    for (int i = 0; i < ir->output_count; i++) {
        visit(&w, ir->outputs[i].value);
        put(&w, (uint32_t)ir->outputs[i].kind << 8 | (uint32_t)ir->outputs[i].index);
        put(&w, ir_type(ir, ir->outputs[i].value));
        put_operand(&w, 0, i, ir->outputs[i].value);
    }
    XXH128_hash_t shape = XXH3_128bits(w.words, w.word_count * sizeof *w.words);
    XXH3_state_t both;
    XXH3_128bits_reset(&both);
    XXH3_128bits_update(&both, &shape, sizeof shape);
    XXH3_128bits_update(&both, w.numbers, w.number_count * sizeof *w.numbers);
    IrKey key = {
        key_of(shape), key_of(XXH3_128bits_digest(&both)), NULL, (int)w.place_count, NULL, 0};
    NumberPlace *places = ARENA_ARRAY(session->arena, NumberPlace, w.place_count + 1);
    if (w.place_count)
        memcpy(places, w.places, w.place_count * sizeof *places);
    key.places = places;
    int *members = ARENA_ARRAY(session->arena, int, w.member_count + 1);
    if (w.member_count)
        memcpy(members, w.members, w.member_count * sizeof *members);
    key.members = members;
    key.member_count = (int)w.member_count;
    arena_free(&scratch);
    return key;
}
