/* Programs of stages other than vertex and fragment. */
#ifndef MATC_STAGES_H
#define MATC_STAGES_H
#include "compiler/base/session.h"
#include "compiler/emit/emit.h"

typedef struct {
    const char *fragment; /* text of the fragment program, given by the caller */
    const char *vertex, *control, *evaluation, *geometry, *compute;
} EmitStages;
/* Generates the programs and links them with the fragment program. Returns false after reporting
 * a fault; the target or the pass may not support the stages. */
bool emit_tessellation_stages(Session *session, const Job *job, const Interface *interface,
                              EmitStages *made);
bool emit_geometry_stages(Session *session, const Job *job, const Interface *interface,
                          EmitStages *made);
/* Emits the compute program, which is linked alone. */
bool emit_compute_stage(Session *session, const Job *job, const Interface *interface,
                        EmitStages *made);
#endif
