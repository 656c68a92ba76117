/* Formats a job as text and JSON. */
#include "compiler/ir/job.h"
#include "compiler/base/json_write.h"

static const char *choice_name(const Job *job, int axis)
{
    return choice_table[job->choice[axis]].name;
}

void job_put_choices(Text *out, const Job *job)
{
    bool any = false;
    for (int axis = 0; axis < AXIS_COUNT; axis++) {
        if ((int)job->choice[axis] == axis_table[axis].first)
            continue;
        text_format(out, "%s %s=%s", any ? "" : "// choices:", axis_table[axis].name,
                    choice_name(job, axis));
        any = true;
    }
    text_put(out, any ? "\n" : "");
}

void job_put_json(Text *out, const Job *job)
{
    text_put(out, "{");
    for (int axis = 0; axis < AXIS_COUNT; axis++) {
        text_put(out, axis ? ", " : "");
        json_member(out, axis_table[axis].name, choice_name(job, axis));
    }
    text_put(out, "}");
}

ReferenceNoise job_noise(Choice noise, Target target)
{
    bool words = target_table[target].words;
    if (noise == CHOICE_noise_groimp)
        return words ? REFERENCE_GROIMP : REFERENCE_GROIMP_FLOAT;
    if (noise == CHOICE_noise_simplex)
        return words ? REFERENCE_SIMPLEX : REFERENCE_SIMPLEX_FLOAT;
    return words ? REFERENCE_LATTICE : REFERENCE_LATTICE_FLOAT;
}
