/* Programs of more stages than vertices and fragments. */
#ifndef MATC_STAGES_H
#define MATC_STAGES_H
#include "compiler/base/session.h"
#include "compiler/emit/emit.h"

typedef struct {
    const char *fragment; /* given */
    const char *vertex, *control, *evaluation, *geometry, *compute;
} EmitStages;
/* All are linked with the fragment program. False: a diagnostic says why; the target or the pass
 * may have no such stages. */
bool emit_tessellation_stages(Session *session, const Job *job, const Interface *interface,
                              EmitStages *made);
bool emit_geometry_stages(Session *session, const Job *job, const Interface *interface,
                          EmitStages *made);
/* It is linked alone. */
bool emit_compute_stage(Session *session, const Job *job, const Interface *interface,
                        EmitStages *made);
#endif
