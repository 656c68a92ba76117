/* Placement by one sweep from users to operands: a node's block is the nearest common one of its uses.
 *
 *     a = noise(p); b = sin(a); c = a * 2; v = select(t, b, c), written as a branch
 *     v lies in main's block, b in the first arm and c in the second, a in main: the nearest that holds both of its uses */
#include "compiler/emit/schedule.h"

enum { BRANCH_COST = 40 }; /* scalar operations in an arm from which on a branch pays */

static int common_block(const Schedule *s, int a, int b)
{
    while (a != b) {
        if (s->blocks[a].depth < s->blocks[b].depth)
            b = s->blocks[b].parent;
        else
            a = s->blocks[a].parent;
    }
    return a;
}

static int add_block(Schedule *s, int parent)
{
    Block block = {.parent = parent, .depth = parent < 0 ? 0 : s->blocks[parent].depth + 1};
    ARENA_PUSH(s->arena, s->blocks, s->block_count, s->block_room, block);
    return (int)s->block_count - 1;
}

static void use(Schedule *s, Ref ref, int block)
{
    s->block[ref] = s->block[ref] < 0 ? block : common_block(s, s->block[ref], block);
    s->uses[ref]++;
}

/* Uses of a select's operands: the arms in blocks of their own, the condition where the select is. */
static void use_arms(const Ir *ir, Schedule *s, Ref ref)
{
    int block = s->block[ref];
    s->arm[ref] = add_block(s, block);
    int other = add_block(s, block);
    use(s, ir_arg(ir, ref, 0), block);
    use(s, ir_arg(ir, ref, 1), s->arm[ref]);
    use(s, ir_arg(ir, ref, 2), other);
}

static double node_cost(const Ir *ir, Ref ref) { return ir_applies(ir, ref) ? BRANCH_COST : ir_cost(ir, ref); }

static void clear(Schedule *s)
{
    s->block_count = 0;
    add_block(s, -1);
    for (size_t i = 0; i < s->nodes.count; i++) {
        Ref ref = s->nodes.at[i];
        s->block[ref] = -1;
        s->uses[ref] = 0;
        s->arm[ref] = 0;
        s->next[ref] = 0;
    }
}

/* A branch that would lie too deep in others is none. */
static void bound_depth(Schedule *s, Ref ref)
{
    if (s->blocks[s->block[ref]].depth >= LIMIT_BRANCHES)
        s->branch[ref] = 0;
}

/* It takes differences between neighbouring pixels, which must all come by. */
static bool needs_neighbours(const Ir *ir, Ref ref)
{
    return ir_is(ir, ref, OP_call) &&
           (ir_at(ir, ref)->payload == FN_imageSampled || ir_at(ir, ref)->payload == FN_imageCentred);
}

static void assign_blocks(const Ir *ir, Schedule *s, const Ref *roots, int count)
{
    clear(s);
    for (int i = 0; i < count; i++)
        use(s, roots[i], 0);
    for (size_t k = 0; k < s->nodes.count; k++) {
        Ref ref = s->nodes.at[k];
        if (needs_neighbours(ir, ref))
            s->block[ref] = 0;
        int block = s->block[ref];
        s->next[ref] = s->blocks[block].first;
        s->blocks[block].first = ref;
        bound_depth(s, ref);
        if (s->branch[ref])
            use_arms(ir, s, ref);
        for (int i = 0; !s->branch[ref] && i < ir_at(ir, ref)->count; i++)
            use(s, ir_arg(ir, ref, i), block);
    }
}

static void add_costs(const Ir *ir, Schedule *s)
{
    for (size_t i = 0; i < s->nodes.count; i++)
        s->blocks[s->block[s->nodes.at[i]]].cost += node_cost(ir, s->nodes.at[i]);
    for (size_t b = s->block_count - 1; b > 0; b--)
        s->blocks[s->blocks[b].parent].cost += s->blocks[b].cost;
}

/* Keeps as branches the selects with an arm that is worth skipping. */
static bool demote(const Ir *ir, Schedule *s)
{
    bool demoted = false;
    if (s->block_count == 1)
        return false;
    add_costs(ir, s);
    for (size_t i = 0; i < s->nodes.count; i++) {
        Ref ref = s->nodes.at[i];
        if (!s->branch[ref])
            continue;
        const Block *a = &s->blocks[s->arm[ref]], *b = a + 1;
        if (a->cost >= BRANCH_COST || b->cost >= BRANCH_COST)
            continue;
        s->branch[ref] = 0;
        demoted = true;
    }
    return demoted;
}

Schedule schedule_new(const Ir *ir, Arena *arena)
{
    return (Schedule){.arena = arena,
                      .nodes = ir_reach_new(ir, arena),
                      .block = ARENA_ARRAY(arena, int, ir->count),
                      .next = ARENA_ARRAY(arena, Ref, ir->count),
                      .uses = ARENA_ARRAY(arena, uint32_t, ir->count),
                      .arm = ARENA_ARRAY(arena, int, ir->count),
                      .branch = ARENA_ARRAY(arena, uint8_t, ir->count)};
}

/* It may be a branch: there is something to skip in an arm. */
static bool has_arms(const Ir *ir, Ref ref)
{
    return ir_is(ir, ref, OP_select) && (ir_at(ir, ir_arg(ir, ref, 1))->count || ir_at(ir, ir_arg(ir, ref, 2))->count);
}

void schedule(Schedule *s, const Ir *ir, const Ref *roots, int count, bool branches)
{
    ir_reach(ir, roots, count, &s->nodes);
    for (size_t i = 0; i < s->nodes.count; i++)
        s->branch[s->nodes.at[i]] = branches && has_arms(ir, s->nodes.at[i]);
    assign_blocks(ir, s, roots, count);
    if (demote(ir, s))
        assign_blocks(ir, s, roots, count);
}
