/* Programs of additional stages, which are generated and linked together. */
#include "compiler/emit/stages.h"
#include "compiler/emit/emit.h"
#include "compiler/emit/validate.h"

static bool has_stages(Session *session, const Job *job, bool has, DiagKind otherwise)
{
    if (has && job->pass != PASS_plane && job->pass != PASS_sky && !job->instances)
        return true;
    diag_add(session, NO_SPAN, otherwise, target_table[job->target].name,
             pass_table[job->pass].name);
    return false;
}

static bool accept(Session *session, const Job *job, const EmitStages *made)
{
    const ValidateStages stages = {{made->vertex, made->control, made->evaluation, made->geometry,
                                    made->fragment, made->compute}};
    const char *log = "";
    if (!session->options->validate || validate_stages(session, job->target, &stages, &log))
        return true;
    diag_add(session, NO_SPAN, DIAG_not_valid, target_table[job->target].name, log);
    return false;
}

bool emit_tessellation_stages(Session *session, const Job *job, const Interface *interface,
                              EmitStages *made)
{
    if (!has_stages(session, job, target_table[job->target].tessellation, DIAG_no_tessellation))
        return false;
    *made =
        (EmitStages){.fragment = made->fragment,
                     .vertex = emit_tessellation(session, job, interface, TESSELLATION_vertex),
                     .control = emit_tessellation(session, job, interface, TESSELLATION_control),
                     .evaluation = emit_tessellation(session, job, interface, TESSELLATION_eval)};
    return accept(session, job, made);
}

bool emit_geometry_stages(Session *session, const Job *job, const Interface *interface,
                          EmitStages *made)
{
    if (!has_stages(session, job, target_table[job->target].geometry, DIAG_no_geometry))
        return false;
    *made = (EmitStages){.fragment = made->fragment,
                         .vertex = emit_geometry(session, job, interface, GEOMETRY_vertex),
                         .geometry = emit_geometry(session, job, interface, GEOMETRY_geometry)};
    return accept(session, job, made);
}

bool emit_compute_stage(Session *session, const Job *job, const Interface *interface,
                        EmitStages *made)
{
    if (!has_stages(session, job, target_table[job->target].compute, DIAG_no_compute))
        return false;
    *made = (EmitStages){.compute = emit_compute(session, job, interface)};
    return accept(session, job, made);
}
