/* --layout=auto: fields by falling size, in as few words as hold them. */
#include "auto_layout.h"
#include "describe.h"
#include "choice.h"
#include "custom.h"
#include "document.h"
#include <stdlib.h>
#include <string.h>

enum { MOST_WORDS = 4 * LAYOUT_TARGETS };

/* Targets of so many words: four, two and one at a time. */
static void choose_formats(LayoutRow *row, int words)
{
    int count = 0;
    for (; words >= 4; words -= 4)
        row->formats[count++] = FORMAT_RGBA32UI;
    if (words >= 2)
        row->formats[count++] = FORMAT_RG32UI;
    if (words % 2)
        row->formats[count++] = FORMAT_R32UI;
    row->formats[count] = FORMAT_none;
}

static int by_size(const void *a, const void *b)
{
    const FieldRow *x = a, *y = b;
    int difference = field_size(y) - field_size(x);
    return difference ? difference : (int)x->source[0].slot - (int)y->source[0].slot;
}

/* The fewest words that hold the fields; false: no layout has so many. */
static bool find_words(LayoutRow *row)
{
    Placement placement;
    for (int words = 1; words <= MOST_WORDS; words++) {
        choose_formats(row, words);
        if (layout_targets(row) <= LAYOUT_TARGETS && !layout_place(row, 0, &placement))
            return true;
    }
    return false;
}

static void put_plan(const Plan *plan, const MatcSlotRange *range, FieldRow *fields, int *count, FixedRow *fixed,
                     int *fixed_count)
{
    if (plan->fate == FATE_field)
        fields[(*count)++] = plan->field;
    if (plan->fate != FATE_fixed)
        return;
    fixed[*fixed_count].slot = plan->slot;
    memcpy(fixed[(*fixed_count)++].value, range->low, sizeof fixed->value);
}

static const char *doc_of(Arena *arena, int materials)
{
    Text text = text_new(arena);
    text_format(&text, materials == 1 ? "Made for one material." : "Made for %d materials.", materials);
    return text.at;
}

static const LayoutRow *make_row(Arena *arena, const MatcRanges *ranges, Plan plans[SLOT_COUNT], double scale)
{
    FieldRow *fields = ARENA_ARRAY(arena, FieldRow, SLOT_COUNT);
    FixedRow *fixed = ARENA_ARRAY(arena, FixedRow, SLOT_COUNT);
    CaseRow *only = ARENA_NEW(arena, CaseRow);
    LayoutRow *row = ARENA_NEW(arena, LayoutRow);
    row->name = "auto";
    row->doc = only->doc = doc_of(arena, ranges->materials);
    row->fixed = fixed;
    row->cases = only;
    row->case_count = 1;
    only->fields = fields;
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        plans[slot] = plan_slot((Slot)slot, &ranges->slot[slot], scale);
        put_plan(&plans[slot], &ranges->slot[slot], fields, &only->field_count, fixed, &row->fixed_count);
    }
    qsort(fields, (size_t)only->field_count, sizeof *fields, by_size);
    return find_words(row) ? row : NULL;
}

MatcLayout *matc_layout_for(const MatcRanges *ranges, double error, const MatcOptions *options)
{
    MatcLayout *layout = calloc(1, sizeof *layout);
    if (!layout)
        abort();
    Plan plans[SLOT_COUNT];
    Locale locale = locale_enter();
    layout->options = options_whole(options);
    layout->c = (Compile){.options = &layout->options, .arena = &layout->arena};
    if (ranges->materials) {
        const double scale = error > 0 ? error / class_table[CLASS_color].error : 1;
        layout->row = make_row(&layout->arena, ranges, plans, scale);
        Text report = text_new(&layout->arena);
        plan_report(&report, plans, ranges, layout->row);
        layout_describe(layout);
        text_put(&report, layout->report);
        layout->report = report.at;
    } else {
        diag_add(&layout->c, NO_SPAN, DIAG_layout_of_none);
    }
    locale_leave(locale);
    return layout;
}
