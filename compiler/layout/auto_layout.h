/* --layout=auto: from ranges to fields. */
#ifndef MATC_AUTO_LAYOUT_H
#define MATC_AUTO_LAYOUT_H
#include "compiler/layout/layout.h"
#include "compiler/ir/ir.h"
#include "compiler/matc.h"
#include "compiler/base/text.h"

/* Ranges of one material's slots, by its optimized IR of the pass value with all slots. */
void auto_ranges(const Ir *ir, MatcRanges *one);
/* The layout of the materials that `ranges` were joined of; `error` is the colours', 0: that of
 * classes.def. NULL: no layout has so many words. The report tells of every slot what became of
 * it. */
const LayoutRow *auto_layout(Arena *arena, const MatcRanges *ranges, double error, Text *report);

/* How a slot is kept. */
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

/* Which slots lie together in a case. */
enum { MOST_AUTO_CASES = 8 };
typedef struct {
    int count;
    unsigned slots[MOST_AUTO_CASES]; /* 1 << slot; few first */
    int materials[MOST_AUTO_CASES];  /* that take it; those of MatcRanges.others all together */
    int words;                       /* of a pixel */
    int words_of_one;                /* if there were but one case */
} Division;

/* The fewest words that hold the fields, each one slot's, and then the fewest cases. A material
 * finds all of its slots in a case. False: no layout has so many words. auto_cases.c */
bool auto_divide(const FieldRow *fields, int count, const MatcRanges *ranges, Division *division);
/* Gives the row so many words: targets of four, two and one. */
void auto_choose_formats(LayoutRow *row, int words);
/* Adds the slots of a material, or of several. What `other` has. auto_sets.c */
void auto_sets_add(MatcRanges *ranges, MatcSlotSet set);
void auto_sets_join(MatcRanges *ranges, const MatcRanges *other);
/* Bits of all groups of a field. auto_plan.c */
int auto_field_bits(const FieldRow *field);
/* Plans a slot at `scale` times the errors of classes.def. auto_plan.c */
Plan auto_plan_slot(Slot slot, const MatcSlotRange *range, double scale);
/* A table of the slots and their fates. auto_report.c */
void auto_report(Text *out, const Plan *plans, const MatcRanges *ranges, const LayoutRow *row,
                 const Division *division);
#endif
