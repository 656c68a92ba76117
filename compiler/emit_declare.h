/* Declarations of a program; between emit.c and interface.c. */
#ifndef MATC_EMIT_DECLARE_H
#define MATC_EMIT_DECLARE_H
#include "emit.h"

void emit_declarations(Compile *c, Text *out, const Ir *ir, const Job *job, const Interface *interface);
/* A varying, on either side: `word` is "in" or "out". */
void emit_varying(Text *out, Target target, Input input, const char *word);
/* The param stands where an int is wanted. */
bool uniform_is_int(const Ir *ir, int uniform);
#endif
