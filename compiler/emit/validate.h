/* glslang: parse and link, and SPIR-V. */
#ifndef MATC_VALIDATE_H
#define MATC_VALIDATE_H
#include "compiler/base/session.h"
#include "grammar/tables.h"

/* Parses both programs and links them. The fragment program begins with so many bytes of declarations: where MatcLinked knows
 * them beside this vertex program, the fragment program is parsed and linked alone. False: *log tells why. */
bool validate(Session *session, Target target, const char *vertex, const char *fragment, size_t declarations,
              const char **log);
/* The fragment program as SPIR-V, in the arena; NULL: *log tells why. */
const char *validate_to_spirv(Session *session, const char *fragment, size_t *size, const char **log);
#endif
