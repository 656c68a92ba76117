/* Scheduling in one sweep from users to operands: a node's block is the nearest common ancestor
 * of the blocks that use it.
 *
 *     a = noise(p); b = sin(a); c = a * 2; v = select(t, b, c), written as a branch
 *     v is in main's block, b in the first arm and c in the second; a is in main, the nearest
 *         block that contains both of its uses
 *
 * Branches on one condition in one block are merged into a region, so that values needed only by
 * several of them are in an arm, too:
 *
 *     a = noise(p); b = sin(a); v = select(t, b, 0); w = select(t, a, 1)
 *     if (t) { a = ..; v = sin(a); w = a; } else { v = 0; w = 1; }
 *
 * A branch cannot be in the region of another branch on which it depends through nodes outside
 * the region. Regions therefore have stages, counted from the end of the scope: a node's stage
 * is the max of its users', plus one for a user in a region. A branch joins a region only if the
 * region's stage is not less than its own. Writing nodes by decreasing stage, regions first
 * within a stage, puts operands before users. */
#include "compiler/emit/schedule.h"

enum { BRANCH_COST = 40 }; /* min cost of an arm, in scalar operations, for which a branch pays */

/* Branches that depend on the same condition. */
typedef struct Condition {
    uint32_t branches;
    uint32_t stage; /* min stage of a region that can contain all of the branches */
    Ref open;       /* first select of the region that other selects may join; 0: none */
} Condition;

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
    ARENA_PUSH(s->arena, s->blocks, s->block_count, s->block_capacity, block);
    return (int)s->block_count - 1;
}

static void use(Schedule *s, Ref ref, int block, uint32_t stage)
{
    s->block[ref] = s->block[ref] < 0 ? block : common_block(s, s->block[ref], block);
    s->stage[ref] = stage > s->stage[ref] ? stage : s->stage[ref];
    s->uses[ref]++;
}

static Condition *condition_of(const Ir *ir, const Schedule *s, Ref branch)
{
    return &s->conditions[ir_arg(ir, branch, 0)];
}

/* Returns true if a branch, all of whose users were visited, may join the open region. */
static bool joins(const Schedule *s, const Condition *condition, Ref ref)
{
    return condition->open && s->block[condition->open] == s->block[ref] &&
           s->stage[condition->open] >= s->stage[ref];
}

static void join(Schedule *s, Ref ref, Ref open)
{
    s->stage[ref] = s->stage[open];
    s->arm[ref] = s->arm[open];
    s->mate[ref] = s->mate[open];
    s->mate[open] = ref;
    s->regions = true;
}

/* Marks uses of a select's operands: the arms in blocks of their own; the condition in the
 * select's block, once per region. */
static void use_arms(const Ir *ir, Schedule *s, Ref ref)
{
    Condition *condition = condition_of(ir, s, ref);
    const bool several = condition->branches > 1, joined = several && joins(s, condition, ref);
    const int block = s->block[ref];
    if (joined) {
        join(s, ref, condition->open);
    } else {
        if (several && condition->stage > s->stage[ref])
            s->stage[ref] = condition->stage;
        condition->open = ref;
        s->arm[ref] = add_block(s, block);
        add_block(s, block);
    }
    const uint32_t stage = s->stage[ref] + several;
    if (!joined)
        use(s, ir_arg(ir, ref, 0), block, stage);
    use(s, ir_arg(ir, ref, 1), s->arm[ref], stage);
    use(s, ir_arg(ir, ref, 2), s->arm[ref] + 1, stage);
}

static double node_cost(const Ir *ir, Ref ref)
{
    return ir_applies(ir, ref) ? BRANCH_COST : ir_cost(ir, ref);
}

static void clear(Schedule *s)
{
    s->block_count = 0;
    s->regions = s->derives = false;
    add_block(s, -1);
    for (size_t i = 0; i < s->nodes.count; i++) {
        Ref ref = s->nodes.at[i];
        s->block[ref] = -1;
        s->stage[ref] = 0;
        s->uses[ref] = 0;
        s->arm[ref] = 0;
        s->mate[ref] = ref;
    }
}

/* Counts the branches of each condition, and finds a common stage: that of the first branch,
 * before any are merged. */
static void find_conditions(const Ir *ir, Schedule *s)
{
    bool several = false;
    for (size_t i = 0; i < s->nodes.count; i++)
        s->conditions[s->nodes.at[i]] = (Condition){0};
    for (size_t i = 0; i < s->nodes.count; i++)
        if (s->branch[s->nodes.at[i]])
            several |= ++condition_of(ir, s, s->nodes.at[i])->branches > 1;
    for (size_t i = 0; several && i < s->nodes.count; i++) {
        Ref ref = s->nodes.at[i];
        uint32_t stage = s->stage[ref];
        if (s->branch[ref] && condition_of(ir, s, ref)->branches > 1) {
            Condition *condition = condition_of(ir, s, ref);
            condition->stage = stage > condition->stage ? stage : condition->stage;
            stage = condition->stage + 1;
        }
        for (int k = 0; k < ir_at(ir, ref)->count; k++)
            if (s->stage[ir_arg(ir, ref, k)] < stage)
                s->stage[ir_arg(ir, ref, k)] = stage;
    }
    for (size_t i = 0; several && i < s->nodes.count; i++)
        s->stage[s->nodes.at[i]] = 0;
}

/* Demotes a branch that is nested too deeply to an expression. */
static void bound_depth(Schedule *s, Ref ref)
{
    if (s->blocks[s->block[ref]].depth >= LIMIT_BRANCHES)
        s->branch[ref] = 0;
}

static void assign_blocks(const Ir *ir, Schedule *s, const Ref *roots, int count)
{
    clear(s);
    find_conditions(ir, s);
    for (int i = 0; i < count; i++)
        use(s, roots[i], 0, 0);
    for (size_t k = 0; k < s->nodes.count; k++) {
        Ref ref = s->nodes.at[k];
        if (ir_needs_neighbours(ir, ref)) {
            s->block[ref] = 0;
            s->derives = true;
        }
        bound_depth(s, ref);
        if (s->branch[ref])
            use_arms(ir, s, ref);
        for (int i = 0; !s->branch[ref] && i < ir_at(ir, ref)->count; i++)
            use(s, ir_arg(ir, ref, i), s->block[ref], s->stage[ref]);
    }
}

static void add_costs(const Ir *ir, Schedule *s)
{
    for (size_t i = 0; i < s->nodes.count; i++)
        s->blocks[s->block[s->nodes.at[i]]].cost += node_cost(ir, s->nodes.at[i]);
    for (size_t b = s->block_count - 1; b > 0; b--)
        s->blocks[s->blocks[b].parent].cost += s->blocks[b].cost;
}

static bool is_computed_in(const Ir *ir, const Schedule *s, Ref value, int block)
{
    return s->block[value] == block && ir_at(ir, value)->count;
}

/* Returns true for a select in a region whose arms compute nothing for it. */
static bool has_empty_arms(const Ir *ir, const Schedule *s, Ref ref)
{
    const int arm = s->arm[ref];
    return s->mate[ref] != ref && !is_computed_in(ir, s, ir_arg(ir, ref, 1), arm) &&
           !is_computed_in(ir, s, ir_arg(ir, ref, 2), arm + 1);
}

/* Keeps only selects with an arm that is worth skipping as branches. Returns whether any was
 * demoted. */
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
        if ((a->cost >= BRANCH_COST || b->cost >= BRANCH_COST) && !has_empty_arms(ir, s, ref))
            continue;
        s->branch[ref] = 0;
        demoted = true;
    }
    return demoted;
}

/* Sorts the nodes, which are in decreasing order, such that regions are contiguous. The greatest
 * select of a region represents the region. */
static void order(Schedule *s)
{
    uint32_t stages = 0;
    size_t place = s->nodes.count;
    for (size_t i = 0; i < s->nodes.count; i++)
        stages = s->stage[s->nodes.at[i]] >= stages ? s->stage[s->nodes.at[i]] + 1 : stages;
    Ref *first = ARENA_ARRAY(s->arena, Ref, 2 * (size_t)stages);
    for (size_t i = 0; i < s->nodes.count; i++) {
        Ref ref = s->nodes.at[i], *list = &first[2 * (size_t)s->stage[ref] + (s->mate[ref] < ref)];
        if (s->mate[ref] > ref)
            continue;
        s->next[ref] = *list;
        *list = ref;
    }
    for (size_t list = 2 * (size_t)stages; list-- > 0;)
        for (Ref ref = first[list]; ref; ref = s->next[ref]) {
            Ref mate = ref;
            do {
                mate = s->mate[mate];
                s->nodes.at[--place] = mate;
            } while (mate != ref);
        }
}

static void link_blocks(Schedule *s)
{
    for (size_t i = 0; i < s->nodes.count; i++) {
        Ref ref = s->nodes.at[i];
        s->next[ref] = s->blocks[s->block[ref]].first;
        s->blocks[s->block[ref]].first = ref;
    }
}

/* Returns true if operand i is evaluated only depending on the first: an arm of a select, the
 * right side of && and ||. */
static bool is_conditional(const Ir *ir, Ref ref, int i)
{
    return i > 0 && (ir_is(ir, ref, OP_select) || ir_is(ir, ref, OP_and) || ir_is(ir, ref, OP_or));
}

/* Finds implicit derivatives that would be inlined within a condition. Their block is 0, but a
 * node with a single use has no statement there:
 *
 *     v = select(t, texture(s, uv).x, 0)    t ? texture(s, uv).x : 0.0 is undefined in some
 *     pixels
 *     a = texture(s, uv); v = t ? a.x : 0.0 */
static void hoist(const Ir *ir, Schedule *s)
{
    uint8_t *within = ARENA_ARRAY(s->arena, uint8_t, ir->count);
    s->hoisted = ARENA_ARRAY(s->arena, uint8_t, ir->count);
    for (size_t k = 0; k < s->nodes.count; k++) {
        const Ref ref = s->nodes.at[k];
        const bool derives = ir_needs_neighbours(ir, ref);
        const bool outside = derives || (s->block[ref] == 0 && s->uses[ref] > 1);
        s->hoisted[ref] = within[ref] && derives;
        for (int i = 0; i < ir_at(ir, ref)->count; i++)
            within[ir_arg(ir, ref, i)] |= (within[ref] && !outside) || is_conditional(ir, ref, i);
    }
}

Schedule schedule_new(const Ir *ir, Arena *arena)
{
    return (Schedule){.arena = arena,
                      .nodes = ir_reach_new(ir, arena),
                      .block = ARENA_ARRAY(arena, int, ir->count),
                      .next = ARENA_ARRAY(arena, Ref, ir->count),
                      .uses = ARENA_ARRAY(arena, uint32_t, ir->count),
                      .arm = ARENA_ARRAY(arena, int, ir->count),
                      .mate = ARENA_ARRAY(arena, Ref, ir->count),
                      .stage = ARENA_ARRAY(arena, uint32_t, ir->count),
                      .conditions = ARENA_ARRAY(arena, Condition, ir->count),
                      .branch = ARENA_ARRAY(arena, uint8_t, ir->count)};
}

/* Returns true for a select with an arm that has something to skip. */
static bool has_arms(const Ir *ir, Ref ref)
{
    return ir_is(ir, ref, OP_select) &&
           (ir_at(ir, ir_arg(ir, ref, 1))->count || ir_at(ir, ir_arg(ir, ref, 2))->count);
}

void schedule(Schedule *s, const Ir *ir, const Ref *roots, int count, bool branches)
{
    ir_reach(ir, roots, count, &s->nodes);
    for (size_t i = 0; i < s->nodes.count; i++)
        s->branch[s->nodes.at[i]] = branches && has_arms(ir, s->nodes.at[i]);
    assign_blocks(ir, s, roots, count);
    if (demote(ir, s))
        assign_blocks(ir, s, roots, count);
    if (s->regions)
        order(s);
    s->hoisted = NULL;
    if (s->derives)
        hoist(ir, s);
    link_blocks(s);
}
