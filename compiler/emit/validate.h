/* Validation by glslang: parsing, linking, and SPIR-V generation. */
#ifndef MATC_VALIDATE_H
#define MATC_VALIDATE_H
#include "compiler/base/session.h"
#include "grammar/tables.h"

/* The programs of a draw call; NULL: absent. */
typedef struct {
    const char *vertex, *fragment;
    size_t declarations; /* bytes of the declarations, at the beginning of the fragment program */
} ProgramTexts;

/* Parses and links both programs. If MatcLinked knows the fragment program's declarations
 * together with this vertex program, only the fragment program is parsed and linked. Returns
 * false and *log on failure. */
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
    const char *text[VALIDATE_STAGES]; /* GLSL by stage; NULL: absent */
} ValidateStages;
bool validate_stages(Session *session, Target target, const ValidateStages *stages,
                     const char **log);
/* Links the programs by Vulkan's rules and returns each as SPIR-V, in the arena. Returns false
 * and *log on failure. */
typedef struct {
    const char *at[VALIDATE_STAGES];
    size_t size[VALIDATE_STAGES]; /* size of each stage's text in bytes */
} ValidateWords;
bool validate_to_spirv(Session *session, const ValidateStages *stages, ValidateWords *words,
                       const char **log);
#endif
