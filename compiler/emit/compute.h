/* Writes the compute program's part of the reflection. */
#ifndef MATC_COMPUTE_H
#define MATC_COMPUTE_H
#include "compiler/emit/emit.h"

void compute_describe(Text *out, const Job *job, const Interface *interface);
#endif
