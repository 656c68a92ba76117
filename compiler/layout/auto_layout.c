/* --layout=auto: derives fields, sorted by decreasing size, packs them into the fewest words,
 * and groups them into cases. */
#include "compiler/layout/auto_layout.h"
#include <stdlib.h>
#include <string.h>

static int by_size(const void *a, const void *b)
{
    const FieldRow *x = a, *y = b;
    int difference = field_size(y) - field_size(x);
    return difference ? difference : (int)x->source[0].slot - (int)y->source[0].slot;
}

/* The parts of a layout: stored fields, and constant slots. */
typedef struct {
    FieldRow fields[SLOT_COUNT];
    int count;
    FixedRow *fixed;
    int fixed_count;
} Parts;

static void put_plan(Parts *parts, const Plan *plan, const MatcSlotRange *range)
{
    if (plan->fate == FATE_field)
        parts->fields[parts->count++] = plan->field;
    if (plan->fate != FATE_fixed)
        return;
    FixedRow *fixed = &parts->fixed[parts->fixed_count++];
    fixed->slot = plan->slot;
    memcpy(fixed->value, range->low, sizeof fixed->value);
}

static const char *doc_of(Arena *arena, int materials)
{
    Text text = text_new(arena);
    text_format(&text, materials == 1 ? "Made for one material." : "Made for %d materials.",
                materials);
    return text.at;
}

/* Describes a case by the slots that distinguish it: "Materials with specular, emissive." */
static const char *doc_of_case(Arena *arena, const Division *division, int number)
{
    unsigned all = division->slots[0];
    Text text = text_new(arena);
    for (int i = 1; i < division->count; i++)
        all &= division->slots[i];
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if ((division->slots[number] & ~all) >> slot & 1)
            text_format(&text, "%s%s", text.size ? ", " : "Materials with ", slot_table[slot].name);
    text_put(&text, text.size ? "." : "Materials with no more than all have.");
    return text.at;
}

static CaseRow make_case(Arena *arena, const FieldRow *fields, int count, unsigned slots)
{
    FieldRow *own = ARENA_ARRAY(arena, FieldRow, SLOT_COUNT);
    CaseRow row = {.fields = own};
    for (int i = 0; i < count; i++)
        if (slots >> fields[i].source[0].slot & 1)
            own[row.field_count++] = fields[i];
    return row;
}

static const LayoutRow *make_row(Arena *arena, const MatcRanges *ranges, Plan plans[SLOT_COUNT],
                                 double scale, Division *division)
{
    Parts parts = {.fixed = ARENA_ARRAY(arena, FixedRow, SLOT_COUNT)};
    CaseRow *cases = ARENA_ARRAY(arena, CaseRow, MAX_AUTO_CASES);
    LayoutRow *row = ARENA_NEW(arena, LayoutRow);
    *row = (LayoutRow){.name = "auto",
                       .doc = doc_of(arena, ranges->materials),
                       .fixed = parts.fixed,
                       .cases = cases};
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        plans[slot] = auto_plan_slot((Slot)slot, &ranges->slot[slot], scale);
        put_plan(&parts, &plans[slot], &ranges->slot[slot]);
    }
    row->fixed_count = parts.fixed_count;
    qsort(parts.fields, (size_t)parts.count, sizeof *parts.fields, by_size);
    if (!auto_divide(parts.fields, parts.count, ranges, division))
        return NULL;
    auto_choose_formats(row, division->words);
    row->case_count = division->count;
    for (int i = 0; i < division->count; i++) {
        cases[i] = make_case(arena, parts.fields, parts.count, division->slots[i]);
        /* the first case has the layout's text */
        cases[i].doc = i ? doc_of_case(arena, division, i) : row->doc;
    }
    return row;
}

const LayoutRow *auto_layout(Arena *arena, const MatcRanges *ranges, double error, Text *report)
{
    Plan plans[SLOT_COUNT];
    Division division;
    const double scale = error > 0 ? error / class_table[CLASS_color].error : 1;
    const LayoutRow *row = make_row(arena, ranges, plans, scale, &division);
    auto_report(report, plans, ranges, row, &division);
    return row;
}
