/* Ranges of the slots of a set of materials: intervals from the optimized IR. */
#include "compiler/layout/auto_layout.h"
#include "compiler/ir/range.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

_Static_assert((int)MATC_SLOTS == (int)SLOT_COUNT, "matc.h knows how many slots there are");

void matc_ranges_init(MatcRanges *ranges)
{
    if (!ranges)
        return;
    /* clears padding too, so that equal ranges are equal bytes */
    memset(ranges, 0, sizeof *ranges);
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        for (int component = 0; component < FIELD_COMPONENTS; component++) {
            ranges->slot[slot].low[component] = INFINITY;
            ranges->slot[slot].high[component] = -INFINITY;
        }
}

void matc_ranges_join(MatcRanges *ranges, const MatcRanges *other)
{
    if (!ranges || !other)
        return;
    ranges->materials += other->materials;
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        MatcSlotRange *to = &ranges->slot[slot];
        const MatcSlotRange *from = &other->slot[slot];
        to->counted += from->counted;
        to->absent += from->absent;
        to->alike += from->alike;
        to->drawn += from->drawn;
        for (int component = 0; component < FIELD_COMPONENTS; component++) {
            to->low[component] = fmin(to->low[component], from->low[component]);
            to->high[component] = fmax(to->high[component], from->high[component]);
        }
    }
    auto_sets_join(ranges, other);
}

/* Returns true if a node's components are equal by construction, given the same for its
 * operands: the SAME lines of ops.def. */
static bool same_numbers(const Ir *ir, Ref ref, const uint8_t *same)
{
    const double *numbers = ir_numbers(ir, ref);
    (void)same;
    for (int i = 1; i < ir_components(ir, ref); i++)
        if (numbers[i] != numbers[0])
            return false;
    return true;
}

static bool same_swizzle(const Ir *ir, Ref ref, const uint8_t *same)
{
    const uint32_t components = ir_at(ir, ref)->payload;
    for (int i = 1; i < ir_components(ir, ref); i++)
        if ((components >> 2 * i & 3) != (components & 3) && !same[ir_arg(ir, ref, 0)])
            return false;
    return true;
}

static bool same_vec(const Ir *ir, Ref ref, const uint8_t *same)
{
    for (int i = 0; i < ir_at(ir, ref)->count; i++)
        if (ir_arg(ir, ref, i) != ir_arg(ir, ref, 0) || !same[ir_arg(ir, ref, i)])
            return false;
    return true;
}

static bool same_apply(const Ir *ir, Ref ref, const uint8_t *same)
{
    return same[ir->functions[ir_at(ir, ref)->payload].result];
}

static bool same_operands(const Ir *ir, Ref ref, const uint8_t *same)
{
    for (int i = 0; i < ir_at(ir, ref)->count; i++)
        if (!same[ir_arg(ir, ref, i)])
            return false;
    return true;
}

static bool same_components(const Ir *ir, Ref ref, const uint8_t *same)
{
    const Op op = (Op)ir_at(ir, ref)->op;
    if (ir_components(ir, ref) == 1)
        return true;
    switch (op) {
#define SAME(name, function)                                                                       \
    case OP_##name:                                                                                \
        return function(ir, ref, same);
#include "grammar/ops.def"
    default:
        return op_table[op].rule == RULE_widest && same_operands(ir, ref, same);
    }
}

static uint8_t *find_same(const Ir *ir, Arena *arena)
{
    uint8_t *same = ARENA_ARRAY(arena, uint8_t, ir->count);
    for (Ref ref = 1; ref < ir->count; ref++)
        same[ref] = same_components(ir, ref, same);
    return same;
}

/* Reads the range of one slot of a material, clipped to the slot's valid range. */
static void read_slot(const Ir *ir, const Ranges *ranges, const uint8_t *same,
                      const IrOutput *output, MatcSlotRange *range)
{
    const SlotRow *row = &slot_table[output->index];
    const Ref value = output->value;
    const bool draws =
        ir_is(ir, value, OP_input) && input_table[ir_at(ir, value)->payload].source == SOURCE_draw;
    range->drawn = draws;
    if (slot_class_table[output->index].kind == CLASS_none || draws)
        return; /* the slot is contained in another slot, or set by the draw call */
    range->counted = 1;
    range->absent = ir_is_number(ir, value, row->absent);
    range->alike = same[value];
    for (int component = 0; component < type_table[row->type].components; component++) {
        Interval found = range_of(ranges, ir, value, component);
        /* Normals are stored in view space, where any direction can occur. */
        if (slot_mixing((Slot)output->index) == MIXING_DIRECTION)
            found = (Interval){row->low, row->high};
        range->low[component] = fmin(fmax(found.low, row->low), row->high);
        range->high[component] = fmax(fmin(found.high, row->high), row->low);
    }
}

/* Returns true if the slot can be greater than 0. */
static bool is_there(const MatcSlotRange *range)
{
    for (int component = 0; component < FIELD_COMPONENTS; component++)
        if (range->counted && range->high[component] > 0)
            return true;
    return false;
}

/* Drops slots without effect in this material. */
static void drop_unneeded(MatcRanges *one)
{
    MatcRanges none;
    unsigned there = 0;
    matc_ranges_init(&none);
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        there |= (unsigned)is_there(&one->slot[slot]) << slot;
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (slot_class_table[slot].matters && !(slot_class_table[slot].matters & there))
            one->slot[slot] = none.slot[slot];
}

void auto_ranges(const Ir *ir, MatcRanges *one)
{
    const Ranges ranges = range_find(ir, ir->arena, FIELD_COMPONENTS);
    const uint8_t *same = find_same(ir, ir->arena);
    one->materials = 1;
    for (int i = 0; i < ir->output_count; i++)
        read_slot(ir, &ranges, same, &ir->outputs[i], &one->slot[ir->outputs[i].index]);
    drop_unneeded(one);
    auto_sets_add(one, (MatcSlotSet){ir->slots, 1});
}
