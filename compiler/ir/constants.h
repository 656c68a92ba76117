/* Numbers that a program reads from a uniform block. Materials that differ only in these numbers
 * share the program. */
#ifndef MATC_CONSTANTS_H
#define MATC_CONSTANTS_H
#include "compiler/ir/ir.h"
#include "compiler/base/text.h"

/* Max constants of a program: each takes at most 16 bytes, and every OpenGL supports blocks of
 * 16 KiB. Further numbers stay literals. */
enum { MAX_CONSTANTS = 1024 };

/* Replaces values that depend only on literals and constants of the block by new constants,
 * computed once on the host. Runs last, before opt_dead. */
void constants_hoist(Ir *ir);

/* A use of a numeric literal: an operand of a node, or an output (user 0). */
typedef struct {
    Ref user;
    int operand; /* index of the operand; for an output, index of the output in the Ir */
    Ref value;   /* literal of a float or word type */
} NumberPlace;
/* Replaces the literal at places[i] by member[i] of the block; -1 keeps it. Places that share a
 * member have equal numbers. The order of the places is that of ir_key's walk. */
void constants_place(Ir *ir, const NumberPlace *places, const int *member, int count);

/* Names the live constants, listed in ir_key's order, and lays them out as a std140 block:
 * widest first, a scalar after each vec3. Sorts the Ir's list by offset; the order is equal for
 * programs of one key. */
void constants_finish(Session *session, Ir *ir, const int *list, size_t count);
/* Returns true for types that a uniform block can hold: floats and words. */
bool constant_storable(Type type);
/* Returns the bits of a component in a block: a float, or an unsigned word. */
uint32_t constant_bits(double value, bool word);
/* Returns the size of the block in bytes, a multiple of 16; 0 if empty. */
int constants_size(const Ir *ir);
#endif
