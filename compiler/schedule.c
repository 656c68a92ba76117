/* Placement by one sweep from users to operands: a node's block is the nearest common one of its uses. */
#include "schedule.h"

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

static void place(const Ir *ir, Schedule *s, const Ref *roots, int count, const uint8_t *branch)
{
    Ref last = 0;
    s->block_count = 0;
    add_block(s, -1);
    for (Ref ref = 0; ref < ir->count; ref++) {
        s->block[ref] = -1;
        s->uses[ref] = 0;
        s->arm[ref] = 0;
        s->next[ref] = 0;
    }
    for (int i = 0; i < count; i++) {
        use(s, roots[i], 0);
        last = roots[i] > last ? roots[i] : last;
    }
    for (Ref ref = last; ref > 0; ref--) {
        int block = s->block[ref];
        if (block < 0)
            continue;
        s->next[ref] = s->blocks[block].first;
        s->blocks[block].first = ref;
        s->blocks[block].cost += node_cost(ir, ref);
        if (branch[ref])
            use_arms(ir, s, ref);
        for (int i = 0; !branch[ref] && i < ir_at(ir, ref)->count; i++)
            use(s, ir_arg(ir, ref, i), block);
    }
    for (size_t b = s->block_count - 1; b > 0; b--)
        s->blocks[s->blocks[b].parent].cost += s->blocks[b].cost;
}

/* Keeps as branches the selects with an arm that is worth skipping. */
static bool demote(const Schedule *s, uint8_t *branch, Ref count)
{
    bool demoted = false;
    for (Ref ref = 1; ref < count; ref++) {
        if (!branch[ref] || s->block[ref] < 0)
            continue;
        const Block *a = &s->blocks[s->arm[ref]], *b = a + 1;
        if (a->cost >= BRANCH_COST || b->cost >= BRANCH_COST)
            continue;
        branch[ref] = 0;
        demoted = true;
    }
    return demoted;
}

Schedule schedule(const Ir *ir, const Ref *roots, int count, bool branches, Arena *arena)
{
    Ref nodes = (Ref)ir->count;
    Schedule s = {.arena = arena,
                  .block = ARENA_ARRAY(arena, int, nodes),
                  .next = ARENA_ARRAY(arena, Ref, nodes),
                  .uses = ARENA_ARRAY(arena, uint32_t, nodes),
                  .arm = ARENA_ARRAY(arena, int, nodes)};
    uint8_t *branch = ARENA_ARRAY(arena, uint8_t, nodes);
    for (Ref ref = 1; branches && ref < nodes; ref++)
        branch[ref] = ir_is(ir, ref, OP_select);
    place(ir, &s, roots, count, branch);
    if (demote(&s, branch, nodes))
        place(ir, &s, roots, count, branch);
    return s;
}
