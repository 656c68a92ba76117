/* Report of an automatic layout: one line per slot. */
#include "compiler/layout/auto_layout.h"

static void put_range(Text *out, double low, double high)
{
    if (low == high) {
        text_rounded(out, low, 6);
        return;
    }
    text_rounded(out, low, 4);
    text_put(out, " to ");
    text_rounded(out, high, 4);
}

static void put_error(Text *out, const Plan *plan)
{
    static const char *const units[] = {[CLASS_UNIT_display] = " of its square root",
                                        [CLASS_UNIT_relative] = " %",
                                        [CLASS_UNIT_degrees] = " degrees",
                                        [CLASS_UNIT_absolute] = ""};
    const ClassUnit unit = class_table[plan->kind].unit;
    text_rounded(out, unit == CLASS_UNIT_relative ? 100 * plan->error : plan->error, 3);
    text_put(out, units[unit]);
}

/* Explains why a slot has no field. */
static void put_fate(Text *out, const Plan *plan, const MatcSlotRange *range, int materials)
{
    const unsigned matters = slot_class_table[plan->slot].matters;
    const char *between = "dropped: no material has ";
    switch (plan->fate) {
    case FATE_fixed:
        text_format(out,
                    range->counted == 1 ? "constant in the only material that uses it"
                                        : "constant in all %d materials that use it",
                    range->counted);
        break;
    case FATE_absent:
        text_format(out,
                    materials == 1 ? "dropped: has no effect"
                                   : "dropped: has no effect in all %d materials",
                    materials);
        break;
    case FATE_taken:
        text_put(out, "dropped: merged into the transparency");
        break;
    default:
        for (int slot = 0; slot < SLOT_COUNT && matters; slot++)
            if (matters >> slot & 1) {
                text_format(out, "%s%s", between, slot_table[slot].name);
                between = " or ";
            }
        if (!matters || *between == ' ')
            text_put(out, plan->slot == SLOT_ior ? ", or the draw tells it" : "");
    }
}

static void put_field(Text *out, const Plan *plan)
{
    const FieldRow *field = &plan->field;
    Text encoding = text_new(out->arena);
    layout_put_encoding(&encoding, field);
    if (field_has_range(field)) {
        text_put(&encoding, " over ");
        layout_put_range(&encoding, field);
    }
    text_format(out, "%-28s %4d  ", encoding.at, auto_field_bits(field));
    put_error(out, plan);
    text_put(out, field->gray ? ", one for all components" : "");
}

/* Lists the cases: "case 0    3 materials    normal, diffuse". */
static void put_cases(Text *out, const Division *division)
{
    text_format(out, "%-25s %-18s %s\n", "case", "materials", "slots that it stores");
    for (int i = 0; i < division->count; i++) {
        const char *between = "";
        text_format(out, "%-25d %-18d ", i, division->materials[i]);
        for (int slot = 0; slot < SLOT_COUNT; slot++)
            if (division->slots[i] >> slot & 1) {
                text_format(out, "%s%s", between, slot_table[slot].name);
                between = ", ";
            }
        text_char(out, '\n');
    }
    text_char(out, '\n');
}

static void put_sizes(Text *out, const MatcRanges *ranges, const LayoutRow *row,
                      const Division *division)
{
    text_format(out, "%d bytes a pixel", layout_bytes(row));
    if (division->count > 1)
        text_format(out, " in %d cases", division->count);
    text_format(out, " for %d materials; ", ranges->materials);
    if (division->count > 1)
        text_format(out, "one case would take %d, ", 4 * division->words_of_one);
    text_format(out, "compact has %d, thesis %d\n", layout_bytes(&layout_table[LAYOUT_compact]),
                layout_bytes(&layout_table[LAYOUT_thesis]));
}

void auto_report(Text *out, const Plan *plans, const MatcRanges *ranges, const LayoutRow *row,
                 const Division *division)
{
    put_sizes(out, ranges, row, division);
    text_format(out, "%-25s %-18s %-28s %4s  %s\n", "slot", "range", "stored as", "bits",
                "error at most");
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        const Plan *plan = &plans[slot];
        Text range = text_new(out->arena);
        text_put(&range, "");
        if (plan->low <= plan->high)
            put_range(&range, plan->low, plan->high);
        text_format(out, "%-25s %-18s ", slot_table[slot].name, range.at);
        if (plan->fate == FATE_field)
            put_field(out, plan);
        else
            put_fate(out, plan, &ranges->slot[slot], ranges->materials);
        text_char(out, '\n');
    }
    text_char(out, '\n');
    if (division->count > 1)
        put_cases(out, division);
}
