/* What the oracle remembers, by the nodes that it has met: a point costs what hangs below its material, and not what else is in
 * the document. */
#include "compiler/oracle/oracle_maps.h"

enum { FIRST_TABLE = 64 };

static uint32_t *place_of(const NodeNumbers *numbers, const Node *node)
{
    uint32_t at = (uint32_t)((uintptr_t)node * 0x9E3779B97F4A7C15u >> 32) & numbers->mask;
    while (numbers->table[at] && numbers->at[numbers->table[at] - 1] != node)
        at = (at + 1) & numbers->mask;
    return &numbers->table[at];
}

static void grow(Arena *arena, NodeNumbers *numbers)
{
    numbers->mask = numbers->table ? 2 * numbers->mask + 1 : FIRST_TABLE - 1;
    numbers->table = ARENA_ARRAY(arena, uint32_t, numbers->mask + 1);
    for (size_t i = 0; i < numbers->count; i++)
        *place_of(numbers, numbers->at[i]) = (uint32_t)i + 1;
}

size_t node_number(Arena *arena, NodeNumbers *numbers, const Node *node)
{
    if (2 * numbers->count >= numbers->mask)
        grow(arena, numbers);
    uint32_t *place = place_of(numbers, node);
    if (!*place) {
        ARENA_PUSH(arena, numbers->at, numbers->count, numbers->room, node);
        *place = (uint32_t)numbers->count;
    }
    return *place - 1;
}

/* The node's answers in that environment. It moves when further nodes are met. */
static MemoRow *row_of(const Environment *environment, const Node *node)
{
    Oracle *oracle = environment->oracle;
    Memo *memo = &oracle->memos[environment->depth];
    size_t number = node_number(&oracle->arena, &memo->nodes, node);
    memo->rows = arena_reach(&oracle->arena, memo->rows, number, &memo->room, sizeof *memo->rows);
    MemoRow *row = &memo->rows[number];
    if (row->stamp != environment->stamp) {
        row->stamp = environment->stamp;
        row->known = 0;
    }
    return row;
}

bool memo_find(const Environment *environment, const Node *node, int channel, double *value)
{
    const MemoRow *row = row_of(environment, node);
    *value = row->value[channel];
    return row->known >> channel & 1;
}

void memo_set(const Environment *environment, const Node *node, int channel, double value)
{
    MemoRow *row = row_of(environment, node);
    row->value[channel] = value;
    row->known |= 1u << channel;
}
