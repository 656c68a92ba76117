/* A job: the target, pass, options and layout of one program. */
#ifndef MATC_JOB_H
#define MATC_JOB_H
#include "compiler/base/text.h"
#include "grammar/layout_tables.h"
#include "compiler/library/reference.h"

typedef struct {
    Target target;
    Pass pass;
    const LayoutRow *layout;
    Slot slot;
    Normals normals; /* space of the normals in a G-buffer: eye or world */
    bool all_slots;  /* pass `value` only: each slot is an output with the slot's number */
    Choice choice[AXIS_COUNT];
    bool from_buffer; /* numbers of the document are read from a uniform block */
    unsigned cases;   /* layout cases that are read back, 1 << case; 0: all */
    bool moved;       /* vertices are already displaced */
    /* also emits a compute program that computes normals of the displaced surface */
    bool computed;
    bool origin; /* positions are relative to INPUT_origin */
    /* An object's matrices and its material's constants are indexed by an attribute
     * (instancing). */
    bool instances;
} Job;

/* Writes "// choices: aa=box powers=pow": choices that differ from their axis' default; nothing
 * if all are defaults. */
void job_put_choices(Text *out, const Job *job);
/* Writes {"noise": "lattice", ...}. */
void job_put_json(Text *out, const Job *job);
/* Returns the lattice noise that a target's programs compute, for the references. */
ReferenceNoise job_noise(Choice noise, Target target);
#endif
