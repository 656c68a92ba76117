/* What a program is written for. */
#ifndef MATC_JOB_H
#define MATC_JOB_H
#include "grammar/tables.h"

typedef struct {
    Target target;
    Pass pass;
    const LayoutRow *layout;
    Slot slot;
    bool all_slots; /* of the pass value: each slot is an output of that number */
    Choice choice[AXIS_COUNT];
    bool from_buffer; /* numbers of the document come from a buffer */
} Job;
#endif
