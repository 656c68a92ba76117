/* A job: the target, pass, options and layout that a program is written for. */
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
    Normals normals; /* of a G-buffer */
    bool all_slots;  /* of the pass value: each slot is an output of that number */
    Choice choice[AXIS_COUNT];
    bool from_buffer; /* numbers of the document come from a buffer */
    unsigned cases;   /* of the layout, 1 << number: those that are read back; 0: all */
    bool moved;       /* vertices stand where they were displaced to */
    bool computed;    /* a compute program is written, too: with the normals of what is displaced */
    bool origin;      /* positions are relative to INPUT_origin */
    /* an object's matrices, and the numbers of its material, are found by an attribute */
    bool instances;
} Job;

/* "// choices: aa=box powers=pow", those that are not their axis' default; nothing when there is
 * none. */
void job_put_choices(Text *out, const Job *job);
/* {"noise": "lattice", ...} */
void job_put_json(Text *out, const Job *job);
/* The lattice noise that a target's programs compute, for the references. */
ReferenceNoise job_noise(Choice noise, Target target);
#endif
