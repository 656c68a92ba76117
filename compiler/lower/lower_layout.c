/* Writes the G-buffer: every slot of a layout, encoded, at its place in a render target. */
#include "compiler/ir/range.h"
#include "compiler/layout/layout.h"
#include "compiler/lower/lower.h"
#include <math.h>

static const double greatest_half = 65504;

/* Returns true for a Principled in a layout without the slot `model`, which cannot distinguish
 * it from a Phong. */
static bool is_lit_as_phong(Lower *l, const Node *material, const Env *env)
{
    return !(l->layout_slots >> SLOT_model & 1) &&
           !ir_is_number(l->ir, lower_slot(l, material, SLOT_model, env), MODEL_Phong);
}

/* Returns the slot as the G-buffer stores it. */
static Ref stored_slot(Lower *l, const Node *material, Slot slot, const Env *env)
{
    if (slot == SLOT_anisotropy)
        return lower_stored_anisotropy(l, material, env);
    if (slot == SLOT_coatNormal)
        return lower_stored_coat_normal(l, material, env);
    if (slot == SLOT_normal)
        return lower_stored_normal(l, material, env);
    return is_lit_as_phong(l, material, env) ? lower_phong_of_principled(l, material, slot, env)
                                             : lower_slot(l, material, slot, env);
}

static Ref one_component(Lower *l, const Node *material, SlotComponent source, const Env *env)
{
    return build_component(l->ir, stored_slot(l, material, source.slot, env), source.component);
}

/* Returns the value of a piece's source. Consecutive components of one slot become a swizzle,
 * others a vector. */
static Ref source_value(Lower *l, const Piece *piece, const Node *material, const Env *env)
{
    const SlotComponent *source = &piece->field->source[piece->first];
    Ref components[FIELD_COMPONENTS];
    if (piece_is_slot(piece))
        return stored_slot(l, material, source[0].slot, env);
    for (int i = 0; i < piece->count; i++)
        components[i] = one_component(l, material, source[i], env);
    return piece->count == 1
               ? components[0]
               : build_vec_of(l->ir, build_components_type(piece->count), components, piece->count);
}

/* Maps a value linearly from the field's range to [0, 1], as a texel stores it. */
static Ref in_range(Lower *l, const FieldRow *field, Ref value)
{
    Ir *ir = l->ir;
    if (!field_has_range(field))
        return value;
    if (field->low != 0)
        value = build_sub(ir, value, build_float(ir, field->low));
    return build_scale(ir, value, 1 / (field->high - field->low));
}

static Ref piece_value(Lower *l, const Piece *piece, const Node *material, const Env *env)
{
    Ir *ir = l->ir;
    int pack = encoding_table[piece->field->encoding].pack;
    Ref args[2] = {in_range(l, piece->field, source_value(l, piece, material, env))};
    if (pack == FN_none) {
        Ref high = build_float(ir, greatest_half), low = build_float(ir, -greatest_half);
        return build_clamp(ir, args[0], low, high);
    }
    if (!piece_takes_bits(piece))
        return build_call_of(ir, pack, args, 1);
    args[1] = build_int(ir, piece->field->bits);
    return build_call_of(ir, pack, args, 2);
}

/* A material, and where its slots are stored. */
typedef struct {
    const Placement *placement;
    const Node *material;
    const Env *env;
} Packed;

/* Combines the pieces of one component of an integer target by shifts. Constant pieces are added
 * to `known` at compile time. */
static Ref word_value(Lower *l, const Packed *p, int target, int component, double known)
{
    Ir *ir = l->ir;
    Ref word = 0;
    for (int i = 0; i < p->placement->count; i++) {
        const Piece *piece = &p->placement->pieces[i];
        if (piece->target != target || piece->component != component)
            continue;
        Ref code = piece_value(l, piece, p->material, p->env);
        ir->origin = ORIGIN_SURFACE; /* origin of a word, which belongs to no single slot */
        if (ir_is(ir, code, OP_const)) {
            known += ldexp(ir_numbers(ir, code)[0], piece->shift);
            continue;
        }
        if (piece->shift)
            code = build_shift(ir, code, build_int(ir, piece->shift));
        word = word ? build_join(ir, word, code) : code;
    }
    Ref rest = ir_const(ir, TYPE_uint, &known);
    return !word ? rest : known != 0 ? build_join(ir, word, rest) : word;
}

/* Returns the words of an integer target. The lowest bits of the first word hold the case's
 * number; a `further` case also sets the highest bit of the last word. */
static Ref words_value(Lower *l, const Packed *p, int target, int number)
{
    Ref words[FIELD_COMPONENTS];
    for (int component = 0; component < FIELD_COMPONENTS; component++) {
        words[component] = word_value(l, p, target, component,
                                      layout_case_code(l->job->layout, number, target, component));
    }
    return build_vec_of(l->ir, TYPE_uvec4, words, FIELD_COMPONENTS);
}

static const Piece *piece_at(const Placement *placement, int target, int component)
{
    for (int i = 0; i < placement->count; i++)
        if (placement->pieces[i].target == target && placement->pieces[i].component == component)
            return &placement->pieces[i];
    return NULL;
}

/* Returns the pieces of a float target, in order. */
static Ref floats_value(Lower *l, const Packed *p, int target)
{
    Ir *ir = l->ir;
    Ref parts[FIELD_COMPONENTS];
    int count = 0;
    for (int component = 0; component < FIELD_COMPONENTS;) {
        const Piece *piece = piece_at(p->placement, target, component);
        parts[count++] = piece ? piece_value(l, piece, p->material, p->env) : build_float(ir, 0);
        component += piece ? piece->size : 1;
    }
    return count == 1 ? parts[0] : build_vec_of(ir, TYPE_vec4, parts, count);
}

/* Returns true if the slot is the constant of a material that does not use it. */
static bool is_absent(Lower *l, const Node *material, Slot slot, const Env *env)
{
    return ir_is_number(l->ir, lower_slot(l, material, slot, env), slot_table[slot].absent);
}

/* Returns true if the slot is not absent, and neither are all slots without which it has no
 * effect. */
static bool is_needed(Lower *l, const Node *material, Slot slot, const Env *env)
{
    const unsigned matters = slot_class_table[slot].matters;
    if (is_absent(l, material, slot, env))
        return false;
    for (int other = 0; other < SLOT_COUNT; other++)
        if (matters >> other & 1 && !is_absent(l, material, (Slot)other, env))
            return true;
    return !matters;
}

/* Returns true if the slot must be stored; a case for all materials also stores slots without
 * effect. */
static bool is_asked(Lower *l, const LayoutRow *row, const Node *material, Slot slot,
                     const Env *env)
{
    return !is_absent(l, material, slot, env) &&
           (layout_is_whole(row) || is_needed(l, material, slot, env));
}

/* Returns true if the slot is the constant that the case restores when it is read. */
static bool is_given(Lower *l, const Node *material, const FixedRow *fixed, const Env *env)
{
    const Ref value = lower_slot(l, material, fixed->slot, env);
    for (int component = 0; component < ir_components(l->ir, value); component++)
        if (!ir_is(l->ir, value, OP_const) ||
            ir_numbers(l->ir, value)[component] != fixed->value[component])
            return false;
    return true;
}

/* Returns true if a case that does not store the slot does not restore the material's value
 * either. */
static bool is_lost(Lower *l, const CaseRow *of, const Node *material, Slot slot, const Env *env)
{
    const FixedRow *fixed = layout_case_fixed(of, slot);
    return fixed ? !is_given(l, material, fixed, env)
                 : is_asked(l, l->job->layout, material, slot, env);
}

/* Returns the set of slots that any case of the layout stores. */
static unsigned stored_slots(const Lower *l)
{
    return l->layout_slots & ~layout_fixed_slots(l->job->layout);
}

/* Returns the slots of `stored` that case `number` loses for this material. */
static unsigned lost_slots(Lower *l, int number, unsigned stored, const Node *material,
                           const Env *env)
{
    const CaseRow *of = &l->job->layout->cases[number];
    const unsigned elsewhere = stored & ~layout_case_slots(of);
    unsigned lost = 0;
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (elsewhere >> slot & 1)
            lost |= (unsigned)is_lost(l, of, material, (Slot)slot, env) << slot;
    return lost;
}

int lower_layout_case(Lower *l, const Node *material, const Env *env)
{
    const LayoutRow *row = l->job->layout;
    const unsigned stored = stored_slots(l);
    int number = 0;
    while (number < row->case_count && lost_slots(l, number, stored, material, env))
        number++;
    return number;
}

static const char *names_of(Lower *l, unsigned slots)
{
    Text names = text_new(l->session->arena);
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (slots >> slot & 1)
            text_format(&names, names.size ? ", %s" : "%s", slot_table[slot].name);
    return names.at;
}

int lower_nearest_case(Lower *l, const Node *material, const Env *env)
{
    const LayoutRow *row = l->job->layout;
    const unsigned stored = stored_slots(l);
    int nearest = row->case_count, fewest = SLOT_COUNT + 1;
    unsigned least = 0;
    for (int number = 0; number < row->case_count && layout_is_whole(row); number++) {
        const unsigned lost = lost_slots(l, number, stored, material, env);
        const int count = __builtin_popcount(lost);
        if (lost >> SLOT_model & 1 || count >= fewest)
            continue;
        nearest = number;
        fewest = count;
        least = lost;
    }
    if (nearest < row->case_count)
        diag_add(l->session, material ? material->span : NO_SPAN, DIAG_case_loses, row->name,
                 names_of(l, least));
    return nearest;
}

void lower_left_out(Lower *l, const Node *material, const Env *env)
{
    const LayoutRow *row = l->job->layout;
    const unsigned slots = l->layout_slots;
    if (slots >> SLOT_model & 1 && !(slots >> SLOT_coatNormal & 1) && layout_is_whole(row) &&
        !is_absent(l, material, SLOT_coatNormal, env))
        diag_add(l->session, material ? material->span : NO_SPAN, DIAG_case_loses, row->name,
                 slot_table[SLOT_coatNormal].name);
}

unsigned lower_needed_slots(Lower *l, const Node *material, const Env *env)
{
    unsigned slots = 1u << SLOT_normal;
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (slot_class_table[slot].kind != CLASS_none && is_needed(l, material, (Slot)slot, env))
            slots |= 1u << slot;
    return slots;
}

void lower_no_case(Lower *l, const Node *material, const Env *env)
{
    const LayoutRow *row = l->job->layout;
    const unsigned stored = stored_slots(l);
    unsigned slots = 0;
    for (int slot = SLOT_normal + 1; slot < SLOT_COUNT; slot++)
        if (stored >> slot & 1)
            slots |= (unsigned)is_needed(l, material, (Slot)slot, env) << slot;
    diag_add(l->session, material ? material->span : NO_SPAN, DIAG_case_none, row->name,
             names_of(l, slots));
    l->failed = true;
}

/* Places the layout's fields; reports a layout that the target's GLSL cannot write, or whose
 * fields do not fit. */
static bool allocate(Lower *l, int number, Placement *placement)
{
    const LayoutRow *row = l->job->layout;
    const FieldRow *fault = layout_allocate(row, number, placement);
    if (fault)
        diag_add(l->session, NO_SPAN, DIAG_layout_full, row->name,
                 encoding_table[fault->encoding].name, slot_table[fault->source[0].slot].name);
    if (!fault && !target_table[l->job->target].words && layout_has_words(row))
        diag_add(l->session, NO_SPAN, DIAG_layout_words, row->name,
                 target_table[l->job->target].name);
    return !l->session->diags.errors;
}

/* Returns true if the value surely differs from what the layout restores; without simplification
 * the value is not known to be constant. */
static bool differs(Lower *l, const FixedRow *fixed, const Node *material, const Env *env)
{
    const double least = 1e-6;
    Ref value = lower_slot(l, material, fixed->slot, env);
    for (int component = 0;
         ir_is(l->ir, value, OP_const) && component < ir_components(l->ir, value); component++)
        if (fabs(ir_numbers(l->ir, value)[component] - fixed->value[component]) >
            least * fmax(1, fabs(fixed->value[component])))
            return true;
    return false;
}

/* Returns true if the slot has an effect: at least one slot on which it depends may be above 0.
 * The exponent of a material without a lobe has no effect. */
static bool matters(Lower *l, Slot slot, const Node *material, const Env *env)
{
    const unsigned to = slot_class_table[slot].matters;
    bool there = !to;
    for (int other = 0; other < SLOT_COUNT && !there; other++) {
        if (!(to >> other & 1))
            continue;
        Arena arena = {0};
        const Ref value = lower_slot(l, material, (Slot)other, env);
        const Ranges ranges = range_find_below(l->ir, &arena, 1, &value, 1);
        there = range_of(&ranges, l->ir, value, 0).high > 0;
        arena_free(&arena);
    }
    return there;
}

static void check_fixed(Lower *l, const LayoutRow *row, const Node *material, const Env *env)
{
    for (int i = 0; i < row->fixed_count; i++)
        if (differs(l, &row->fixed[i], material, env) &&
            matters(l, row->fixed[i].slot, material, env))
            diag_add(l->session, NO_SPAN, DIAG_layout_fixed, row->name,
                     slot_table[row->fixed[i].slot].name);
}

/* Warns of a Principled in a layout without the slot `model`, and lists the slots that are lost. */
static void check_model(Lower *l, const LayoutRow *row, const Node *material, const Env *env)
{
    Text slots = text_new(l->session->arena);
    if (!is_lit_as_phong(l, material, env))
        return;
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (!(l->layout_slots >> slot & 1) && slot_class_table[slot].matters >> SLOT_model & 1 &&
            !is_absent(l, material, (Slot)slot, env))
            text_format(&slots, "%s, ", slot_table[slot].name);
    text_put(&slots, slot_table[SLOT_model].name);
    diag_add(l->session, material->span, DIAG_layout_model, row->name, slots.at);
}

void lower_layout(Lower *l, int number, const Node *material, const Env *env)
{
    const LayoutRow *row = l->job->layout;
    Placement placement;
    if (!allocate(l, number, &placement)) {
        l->failed = true;
        return;
    }
    l->ir->layout_case = number;
    check_fixed(l, row, material, env);
    check_model(l, row, material, env);
    const Packed packed = {&placement, material, env};
    for (int target = 0; target < layout_targets(row); target++)
        ir_output(l->ir, OUT_color, target,
                  format_table[row->formats[target]].words ? words_value(l, &packed, target, number)
                                                           : floats_value(l, &packed, target));
}
