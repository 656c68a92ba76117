/* Key of a program: a hash of everything that its text depends on, except names and comments. */
#ifndef MATC_KEY_H
#define MATC_KEY_H
#include "compiler/ir/constants.h"
#include "compiler/base/hash.h"

typedef struct {
    /* with every number of a place left out: programs of one shape can be one, with the numbers in
     * a buffer */
    Key shape;
    Key key;                   /* with the numbers, but for those that come from a buffer already */
    const NumberPlace *places; /* where the numbers are, in the order of the walk */
    int place_count;
    /* the constants that come from a buffer, in the order of the walk: indices in the Ir */
    const int *members;
    int member_count;
} IrKey;

/* Walks the DAG from its outputs; equal programs are walked alike however their nodes are numbered.
 * `ir` is free of dead functions and textures (opt_dead). The places are in the compilation's
 * arena. */
IrKey ir_key(Session *session, const Ir *ir, const Job *job);
#endif
