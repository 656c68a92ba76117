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

/* Parses both programs and links them. Where MatcLinked knows the declarations beside this vertex
 * program, the fragment program is parsed and linked alone. False: *log tells why. */
bool validate(Session *session, Target target, const ProgramTexts *texts, const char **log);
/* Validates programs of any stages. */
typedef enum {
    VALIDATE_vertex,
    VALIDATE_control,
    VALIDATE_evaluation,
    VALIDATE_geometry,
    VALIDATE_fragment,
    VALIDATE_compute,
    VALIDATE_STAGES
} ValidateStage;
typedef struct {
    const char *text[VALIDATE_STAGES]; /* NULL: there is none */
} ValidateStages;
bool validate_stages(Session *session, Target target, const ValidateStages *stages,
                     const char **log);
/* Links them by Vulkan's rules, and gives each as SPIR-V, in the arena. False: *log tells why. */
typedef struct {
    const char *at[VALIDATE_STAGES];
    size_t size[VALIDATE_STAGES]; /* in bytes */
} ValidateWords;
bool validate_to_spirv(Session *session, const ValidateStages *stages, ValidateWords *words,
                       const char **log);
#endif
