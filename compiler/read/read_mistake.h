/* Faults of YAML in words of indentation and colons, which authors think in, and not in those of
 * its grammar. */
#ifndef MATC_READ_MISTAKE_H
#define MATC_READ_MISTAKE_H
#include "compiler/base/session.h"

/* Message of libyaml, and its place in bytes of the source. */
typedef struct {
    const char *problem;
    uint32_t at, context, file; /* context: where what it was reading begins */
} YamlFault;

/* True: the fault is a common one, and it is said. */
bool read_mistake(Session *session, const YamlFault *fault);
#endif
