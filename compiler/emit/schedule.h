/* Where each node of a scope (main or one function) is computed: in the scope itself, or in one arm
 * of a select that is written as if/else because its arms are costly. A node lies in the innermost
 * block that holds all of its uses, so nothing is set in one branch and read in another. Selects by
 * one condition are a region: one if/else that sets all of them. */
#ifndef MATC_SCHEDULE_H
#define MATC_SCHEDULE_H
#include "compiler/ir/ir.h"

typedef struct {
    int parent, depth; /* block 0 is the scope itself */
    Ref first;         /* its nodes in order, linked by Schedule.next */
    double cost;       /* of its nodes and the blocks in it; where there is more than one block */
} Block;

/* The arrays by Ref serve one scope after the other. */
typedef struct {
    Arena *arena;
    IrReach nodes; /* of the scope, users before operands; of a region one behind the other */
    Block *blocks;
    size_t block_count, block_room;
    bool regions; /* there are some */
    bool derives; /* the program has implicit derivatives */
    /* by Ref: an implicit derivative that gets a statement, or it would stand in a condition; NULL:
     * there is none */
    uint8_t *hoisted;
    int *block;     /* by Ref: where it lies */
    Ref *next;      /* by Ref */
    uint32_t *uses; /* by Ref: in this scope */
    /* by Ref of a select written as if/else: its block for true; the one for false is the next;
     * else 0 */
    int *arm;
    /* by Ref: of a region the next greater, of its greatest the least; itself where it is in
     * none */
    Ref *mate;
    uint8_t *branch; /* by Ref: a select that is written as if/else */
    /* by Ref: how many regions there are at most behind it, one after the other; schedule.c */
    uint32_t *stage;
    struct Condition *conditions; /* by Ref of a condition; schedule.c */
} Schedule;

Schedule schedule_new(const Ir *ir, Arena *arena);
/* Gives a block to what `roots` need. Without `branches` every select is an expression. */
void schedule(Schedule *s, const Ir *ir, const Ref *roots, int count, bool branches);
#endif
