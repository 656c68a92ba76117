/* Numbers that a program reads from a buffer: materials that differ only in them share the
 * program. */
#ifndef MATC_CONSTANTS_H
#define MATC_CONSTANTS_H
#include "compiler/ir/ir.h"
#include "compiler/base/text.h"

/* The most of a program: each takes 16 bytes at most, and every OpenGL has room for 16 KiB. Further
 * ones stay in the program. */
enum { MOST_CONSTANTS = 1024 };

/* Turns values that depend only on such numbers and constants into such numbers, computed once on
 * the host. Runs last, before opt_dead. */
void constants_hoist(Ir *ir);

/* A place where a program says a number: an operand of a node, or an output (user 0). */
typedef struct {
    Ref user;
    int operand; /* or the output's index in the Ir */
    Ref value;   /* a constant of a float or word type */
} NumberPlace;
/* The member of the buffer that each place becomes, -1 to leave it; places that become one member
 * have equal numbers. The order of the places is that of ir_key's walk. */
void constants_place(Ir *ir, const NumberPlace *places, const int *member, int count);

/* Names the live constants, given as ir_key lists them, and lays them out as a std140 block: widest
 * first, a number behind each triple. The Ir's list is then in the order of the offsets, the same
 * for programs of one key. */
void constants_finish(Session *session, Ir *ir, const int *list, size_t count);
/* A buffer can hold numbers of the type: floats and words. */
bool constant_storable(Type type);
/* A lane as a buffer holds it: a float, or a word as it is. */
uint32_t constant_bits(double value, bool word);
/* Bytes of the block, a multiple of 16; 0 for none. */
int constants_size(const Ir *ir);
#endif
