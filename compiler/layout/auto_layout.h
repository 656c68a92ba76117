/* --layout=auto: derives the fields of a layout from the ranges of slots. */
#ifndef MATC_AUTO_LAYOUT_H
#define MATC_AUTO_LAYOUT_H
#include "compiler/layout/layout.h"
#include "compiler/ir/ir.h"
#include "compiler/matc.h"
#include "compiler/base/text.h"

/* Finds the ranges of a material's slots from its optimized IR (pass `value`, all slots). */
void auto_ranges(const Ir *ir, MatcRanges *one);
/* Returns a layout for the materials whose ranges were joined in `ranges`. `error` is the max
 * error of colors; 0 selects that of classes.def. NULL: no layout has enough words. The report
 * explains the encoding of every slot. */
const LayoutRow *auto_layout(Arena *arena, const MatcRanges *ranges, double error, Text *report);

/* How a layout treats a slot. */
typedef enum {
    FATE_field,    /* the slot is stored in a field */
    FATE_fixed,    /* the slot is constant and equal in all materials */
    FATE_absent,   /* the slot is absent in all materials */
    FATE_unneeded, /* the slot has no effect in any material */
    FATE_taken,    /* another slot contains the slot */
} Fate;

typedef struct {
    Slot slot;
    Fate fate;
    double low, high; /* range of the values of all components */
    ErrorClass kind;
    double error; /* max error in the unit of the error class; for a field its actual error */
    FieldRow field;
} Plan;

/* Assignment of slots to cases. */
enum { MAX_AUTO_CASES = 8 };
typedef struct {
    int count;
    /* sets of slots of the cases, as bits 1 << slot; smallest set first */
    unsigned slots[MAX_AUTO_CASES];
    /* number of materials per case; all of MatcRanges.others count together */
    int materials[MAX_AUTO_CASES];
    int words;        /* words per pixel */
    int words_of_one; /* words per pixel with a single case */
} Division;

/* Finds the fewest words that hold the fields (one slot each), then the fewest cases. Each
 * material has a case with all of its slots. Returns false if no layout has enough words.
 * auto_cases.c */
bool auto_divide(const FieldRow *fields, int count, const MatcRanges *ranges, Division *division);
/* Sets the row's formats: targets of four, two and one words. */
void auto_choose_formats(LayoutRow *row, int words);
/* Adds the slot set of a material; auto_sets_join() adds all sets of `other`. auto_sets.c */
void auto_sets_add(MatcRanges *ranges, MatcSlotSet set);
void auto_sets_join(MatcRanges *ranges, const MatcRanges *other);
/* Returns the bits of all groups of a field. auto_plan.c */
int auto_field_bits(const FieldRow *field);
/* Selects the encoding of a slot for `scale` times the errors of classes.def. auto_plan.c */
Plan auto_plan_slot(Slot slot, const MatcSlotRange *range, double scale);
/* Writes a table of the slots and their treatment. auto_report.c */
void auto_report(Text *out, const Plan *plans, const MatcRanges *ranges, const LayoutRow *row,
                 const Division *division);
#endif
