/* Selects the cheapest encoding of a slot: the fewest bits that keep its class' error over its
 * range. */
#include "compiler/layout/auto_layout.h"
#include <math.h>

/* Relative tolerance that absorbs rounding errors. */
static const double SAME = 1e-9;

typedef struct {
    const Plan *plan;
    bool gray;
    int components;
} Wish;

static double displayed(double value) { return sqrt(fmin(fmax(value, 0), 1)); }

/* Returns the error of a field in the unit of the slot's class. */
static double class_error(const Plan *plan, const FieldRow *field)
{
    const double step = field_error(field);
    switch (class_table[plan->kind].unit) {
    case CLASS_UNIT_display:
        /* a square root's codes have uniform steps: half a step */
        if (field->encoding == ENCODING_root)
            return sqrt(field_high(field)) * .5 / (ldexp(1, field->bits) - 1);
        return displayed(fmax(plan->low, 0) + step) - displayed(plan->low);
    case CLASS_UNIT_relative:
        return encoding_table[field->encoding].unit == UNIT_relative
                   ? step
                   : step / fmax(plan->low, 1e-30);
    default:
        return step;
    }
}

static FieldRow make_field(const Wish *wish, Encoding encoding)
{
    FieldRow field = {
        .encoding = encoding, .count = wish->gray ? 1 : wish->components, .gray = wish->gray};
    for (int component = 0; component < field.count; component++)
        field.source[component] = (SlotComponent){wish->plan->slot, component};
    return field;
}

int auto_field_bits(const FieldRow *field)
{
    const int takes = encoding_table[field->encoding].takes;
    return field_size(field) * (takes ? field->count / takes : 1);
}

/* Tries an encoding with the fewest sufficient bits; keeps it in *best if it takes fewer bits
 * than the best so far. */
static void try_encoding(const Wish *wish, Encoding encoding, double low, double high,
                         FieldRow *best)
{
    const EncodingRow *row = &encoding_table[encoding];
    FieldRow field = make_field(wish, encoding);
    if (row->takes && field.count % row->takes)
        return;
    field.low = low;
    field.high = high;
    for (field.bits = row->least; field.bits < row->most; field.bits++)
        if (class_error(wish->plan, &field) <= wish->plan->error * (1 + SAME))
            break;
    const bool does = class_error(wish->plan, &field) <= wish->plan->error * (1 + SAME);
    const bool better = !best->bits || auto_field_bits(&field) < auto_field_bits(best);
    const bool best_does =
        best->bits && class_error(wish->plan, best) <= wish->plan->error * (1 + SAME);
    if (does ? !best_does || better : !best->bits)
        *best = field;
}

/* Tries the default range [0, 1], and the actual range if that saves bits. */
static void try_range(const Wish *wish, Encoding encoding, double low, FieldRow *best)
{
    const Plan *plan = wish->plan;
    if (plan->low >= 0 && plan->high <= 1 + SAME)
        try_encoding(wish, encoding, 0, 0, best);
    if (plan->high - low > SAME * fmax(fabs(low), fabs(plan->high)) && isfinite(plan->high))
        try_encoding(wish, encoding, low, plan->high, best);
}

static FieldRow best_field(const Wish *wish)
{
    const Plan *plan = wish->plan;
    FieldRow best = {.encoding = ENCODING_half};
    switch (class_table[plan->kind].unit) {
    case CLASS_UNIT_degrees:
        try_encoding(wish, ENCODING_octahedral, 0, 0, &best);
        break;
    case CLASS_UNIT_display:
        try_range(wish, ENCODING_unorm, plan->low, &best);
        try_range(wish, ENCODING_root, 0, &best);
        break;
    case CLASS_UNIT_relative:
        if (wish->components == 3)
            try_encoding(wish, ENCODING_sharedExponent, 0, 0, &best);
        else
            try_encoding(wish, ENCODING_logarithm, 0, 0, &best);
        if (plan->low > 0)
            try_range(wish, ENCODING_unorm, plan->low, &best);
        try_encoding(wish, ENCODING_half, 0, 0, &best);
        break;
    case CLASS_UNIT_absolute:
        try_range(wish, ENCODING_unorm, plan->low, &best);
    }
    return best;
}

/* Returns true if each component is the same number in all materials. */
static bool is_constant(const MatcSlotRange *range, int components)
{
    for (int component = 0; component < components; component++)
        if (range->low[component] != range->high[component])
            return false;
    return true;
}

/* Widens the range of a slot that the draw call sets for some materials: any value of the slot
 * is possible. */
static MatcSlotRange with_drawn(Slot slot, MatcSlotRange range)
{
    for (int component = 0; component < FIELD_COMPONENTS && range.counted && range.drawn;
         component++) {
        range.low[component] = slot_table[slot].low;
        range.high[component] = slot_table[slot].high;
    }
    return range;
}

Plan auto_plan_slot(Slot slot, const MatcSlotRange *of, double scale)
{
    const MatcSlotRange own = with_drawn(slot, *of), *range = &own;
    const SlotClassRow *row = &slot_class_table[slot];
    const int components = type_table[slot_table[slot].type].components;
    Plan plan = {.slot = slot, .low = INFINITY, .high = -INFINITY};
    for (int component = 0; component < components; component++) {
        plan.low = fmin(plan.low, range->low[component]);
        plan.high = fmax(plan.high, range->high[component]);
    }
    plan.kind = plan.high > 1 + 1e-4 ? row->above : row->kind;
    plan.error = class_table[plan.kind].error * scale;
    if (row->kind == CLASS_none || !range->counted) {
        plan.fate = row->kind == CLASS_none ? FATE_taken : FATE_unneeded;
        return plan;
    }
    if (is_constant(range, components)) {
        plan.fate = range->absent == range->counted ? FATE_absent : FATE_fixed;
        return plan;
    }
    if (row->kind == CLASS_color && plan.kind == CLASS_color)
        plan.high = fmin(plan.high, 1);
    plan.fate = FATE_field;
    const bool gray = components > 1 && range->alike == range->counted &&
                      class_table[plan.kind].unit != CLASS_UNIT_degrees;
    /* directions always use a direction encoding, whatever the ranges of their components */
    plan.field = best_field(&(Wish){&plan, gray, components});
    plan.error = class_error(&plan, &plan.field);
    return plan;
}
