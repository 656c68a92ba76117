/* glslang: parse and link, and SPIR-V. */
#ifndef MATC_VALIDATE_H
#define MATC_VALIDATE_H
#include "compiler/base/session.h"
#include "grammar/tables.h"

/* The programs that are drawn together; NULL: there is none. */
typedef struct {
    const char *vertex, *fragment;
    size_t declarations; /* bytes of them, at the beginning of the fragment program */
} ProgramTexts;

/* Parses both programs and links them. Where MatcLinked knows the declarations beside this vertex program, the fragment program
 * is parsed and linked alone. False: *log tells why. */
bool validate(Session *session, Target target, const ProgramTexts *texts, const char **log);
/* The same of programs of more stages; NULL: there is none. */
typedef struct {
    const char *vertex, *control, *evaluation, *geometry, *fragment;
} ValidateStages;
bool validate_stages(Session *session, Target target, const ValidateStages *stages, const char **log);
/* The fragment program as SPIR-V, in the arena; NULL: *log tells why. */
const char *validate_to_spirv(Session *session, const char *fragment, size_t *size, const char **log);
#endif
