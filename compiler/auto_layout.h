/* --layout=auto: from ranges to fields. */
#ifndef MATC_AUTO_LAYOUT_H
#define MATC_AUTO_LAYOUT_H
#include "layout.h"
#include "matc.h"
#include "text.h"

/* What becomes of a slot. */
typedef enum {
    FATE_field,    /* it is stored */
    FATE_fixed,    /* all materials have the same of it */
    FATE_absent,   /* no material says anything about it */
    FATE_unneeded, /* it changes nothing in any material */
    FATE_taken,    /* another slot has it in */
} Fate;

typedef struct {
    Slot slot;
    Fate fate;
    double low, high; /* of all lanes */
    ErrorClass kind;
    double error; /* at most, in the unit of its class; of a field what it really is */
    FieldRow field;
} Plan;

/* What is to be done with a slot, at `scale` times the errors of classes.def. auto_plan.c */
Plan plan_slot(Slot slot, const MatcSlotRange *range, double scale);
/* A table of the slots and their fates. auto_report.c */
void plan_report(Text *out, const Plan *plans, const MatcRanges *ranges, const LayoutRow *row);
#endif
