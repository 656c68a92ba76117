/* Schedules the nodes of a scope (main or one function). A node is computed in the scope itself,
 * or in an arm of a select that is written as if/else because its arms are costly. Its block is
 * the innermost that contains all of its uses, so no value is set in one branch and read in
 * another. Selects on one condition form a region: one if/else that sets all of them. */
#ifndef MATC_SCHEDULE_H
#define MATC_SCHEDULE_H
#include "compiler/ir/ir.h"

typedef struct {
    int parent, depth; /* block 0 is the scope itself */
    Ref first;         /* first node of the block; Schedule.next links the others in order */
    /* cost of the block's nodes and nested blocks; only set if there are several blocks */
    double cost;
} Block;

/* The arrays by Ref are reused for all scopes in turn. */
typedef struct {
    Arena *arena;
    IrReach nodes; /* nodes of the scope, users before operands; regions contiguous */
    Block *blocks;
    size_t block_count, block_capacity;
    bool regions; /* the scope has regions */
    bool derives; /* the program has implicit derivatives */
    /* Per Ref: an implicit derivative that gets its own statement, since it would otherwise be
     * inlined in a condition. NULL: none. */
    uint8_t *hoisted;
    int *block;     /* per Ref: the node's block */
    Ref *next;      /* per Ref: the next node of the same block */
    uint32_t *uses; /* per Ref: number of uses in this scope */
    /* Per Ref of a select written as if/else: the block for true; the block for false has the
     * next number. 0 for other nodes. */
    int *arm;
    /* Per Ref: circular list of a region's selects, in increasing order; the node itself outside
     * regions. */
    Ref *mate;
    uint8_t *branch; /* per Ref: the node is a select written as if/else */
    /* Per Ref: max number of successive regions after the node; schedule.c. */
    uint32_t *stage;
    struct Condition *conditions; /* indexed by the Ref of a condition; internal to schedule.c */
} Schedule;

Schedule schedule_new(const Ir *ir, Arena *arena);
/* Assigns a block to every node that `roots` need. Without `branches` every select is an
 * expression. */
void schedule(Schedule *s, const Ir *ir, const Ref *roots, int count, bool branches);
#endif
