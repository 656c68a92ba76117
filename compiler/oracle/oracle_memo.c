/* The memo of the oracle, by visited nodes: a point costs as much as the nodes below its
 * material, independent of the rest of the document. */
#include "compiler/oracle/oracle_maps.h"

size_t node_number(Arena *arena, NodeNumbers *numbers, const Node *node)
{
    const uint32_t hash = hash_pointer(node);
    for (HashProbe probe = hash_probe(&numbers->index, hash); hash_probe_next(&probe);)
        if (numbers->at[probe.number] == node)
            return probe.number;
    hash_index_add(arena, &numbers->index, hash, (uint32_t)numbers->count);
    ARENA_PUSH(arena, numbers->at, numbers->count, numbers->capacity, node);
    return numbers->count - 1;
}

/* Returns the node's cached values in the environment. The pointer is invalidated by the first
 * visit of another node. */
static MemoRow *row_of(const Environment *environment, const Node *node)
{
    Oracle *oracle = environment->oracle;
    Memo *memo = &oracle->memos[environment->depth];
    size_t number = node_number(&oracle->arena, &memo->nodes, node);
    memo->rows =
        arena_reach(&oracle->arena, memo->rows, number, &memo->capacity, sizeof *memo->rows);
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
