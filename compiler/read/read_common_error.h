/* Explains YAML syntax errors in terms of indentation and colons, which authors know, instead of
 * YAML's grammar. */
#ifndef MATC_READ_COMMON_ERROR_H
#define MATC_READ_COMMON_ERROR_H
#include "compiler/base/session.h"

/* A message of libyaml, and its position in bytes of the source. */
typedef struct {
    const char *problem;
    uint32_t at, context, file; /* `context` is the start of the enclosing construct */
} YamlFault;

/* Returns true if the error is a common one, which has then been reported. */
bool read_common_error(Session *session, const YamlFault *fault);
#endif
