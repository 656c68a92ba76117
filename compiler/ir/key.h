/* Key of a program: a hash of everything that determines its text, except names and comments. */
#ifndef MATC_KEY_H
#define MATC_KEY_H
#include "compiler/ir/constants.h"
#include "compiler/base/hash.h"

typedef struct {
    /* Hash without the numbers at places: programs of one shape can be merged into one that
     * reads its numbers from a uniform block. */
    Key shape;
    Key key;                   /* hash with all numbers except those already in a uniform block */
    const NumberPlace *places; /* uses of literals, in the order of the walk */
    int place_count;
    /* Constants of the uniform block in the order of the walk: indices in the Ir. */
    const int *members;
    int member_count;
} IrKey;

/* Walks the DAG from its outputs. Equal programs yield equal walks, independent of node numbers.
 * `ir` must be free of dead functions and textures (opt_dead). The places are in the session's
 * arena. */
IrKey ir_key(Session *session, const Ir *ir, const Job *job);
#endif
