/* Checks a layout file: possible fields, complete slots, sufficiently large targets. */
#include "compiler/layout/layout_read.h"

typedef struct {
    Session *session;
    const LayoutRow *row;
    bool fine;
} Checker;

static const char *number_text(Checker *k, double value)
{
    Text text = text_new(k->session->arena);
    text_plain(&text, value);
    return text.at;
}

/* Formats "shininess", or "diffuse.g" for a slot with several components. */
static const char *component_text(Checker *k, SlotComponent at)
{
    Text text = text_new(k->session->arena);
    text_put(&text, slot_table[at.slot].name);
    if (type_table[slot_table[at.slot].type].components > 1)
        text_format(&text, ".%c", "rgba"[at.component]);
    return text.at;
}

static void check_groups(Checker *k, const FieldRow *field, Span span)
{
    const EncodingRow *encoding = &encoding_table[field->encoding];
    Text takes = text_new(k->session->arena);
    if (!field->count || !encoding->takes || field->count % encoding->takes == 0)
        return;
    text_format(&takes, "%d components", encoding->takes);
    diag_add(k->session, span, DIAG_field_components, encoding->name, takes.at, field->count);
    k->fine = false;
}

/* Direction encodings are for the normal only; a signed slot needs a signed encoding or range. */
static void check_meaning(Checker *k, const FieldRow *field, Span span)
{
    const EncodingRow *encoding = &encoding_table[field->encoding];
    const bool directions = encoding->unit == UNIT_degrees;
    bool fine = true;
    for (int i = 0; i < field->count && fine; i++) {
        const SlotRow *slot = &slot_table[field->source[i].slot];
        if (directions && (slot_mixing(field->source[i].slot) != MIXING_DIRECTION ||
                           field->source[i].component != i))
            fine = diag_add(k->session, span, DIAG_field_normal, encoding->name);
        else if (!directions && slot->low < 0 && field_low(field) >= 0)
            fine = diag_add(k->session, span, DIAG_field_sign, encoding->name,
                            number_text(k, field_low(field)), number_text(k, field_high(field)),
                            slot->name, number_text(k, slot->low), number_text(k, slot->high));
    }
    k->fine &= fine;
}

/* Checks that every component is stored at most once, and no component of a stored slot is
 * missing. */
static void check_components(Checker *k, const CaseRow *row, Tree *const *trees)
{
    /* per component of a slot: number of the field that stores it, from 1 */
    int last[SLOT_COUNT][FIELD_COMPONENTS] = {{0}};
    for (int i = 0; i < row->field_count; i++)
        for (int component = 0; component < row->fields[i].count; component++) {
            const SlotComponent at = row->fields[i].source[component];
            const int components =
                row->fields[i].gray ? type_table[slot_table[at.slot].type].components : 1;
            if (last[at.slot][at.component])
                k->fine =
                    diag_add(k->session, trees[i]->span, DIAG_slot_twice, component_text(k, at));
            for (int n = 0; n < components; n++)
                last[at.slot][at.component + n] = i + 1;
        }
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        int stored = 0;
        for (int component = 0; component < FIELD_COMPONENTS; component++)
            stored = last[slot][component] ? last[slot][component] : stored;
        for (int component = 0; stored && component < type_table[slot_table[slot].type].components;
             component++)
            if (!last[slot][component])
                k->fine = diag_add(k->session, trees[stored - 1]->span, DIAG_slot_in_part,
                                   component_text(k, (SlotComponent){(Slot)slot, component}),
                                   slot_table[slot].name);
    }
}

/* Lists the free bits or components that the preceding fields leave: "left are 3 bits of 0.r, 32
 * bits of 1.g", "left are 0.a, 2.r". */
static const char *left_text(Checker *k, const Placement *placement, bool words)
{
    Text text = text_new(k->session->arena);
    bool any = false;
    for (int target = 0; target < layout_targets(k->row); target++) {
        const FormatRow *format = &format_table[k->row->formats[target]];
        any |= format->words == words;
        for (int component = 0; component < format->components && format->words == words;
             component++) {
            int left = format->bits - (target || component ? 0 : layout_case_bits(k->row));
            for (int i = 0; i < placement->count; i++) {
                const Piece *piece = &placement->pieces[i];
                if (piece->target == target && component >= piece->component &&
                    component < piece->component + (words ? 1 : piece->size))
                    left = words ? left - piece->size : 0;
            }
            if (!left)
                continue;
            text_put(&text, text.size ? ", " : "left are ");
            if (words)
                text_format(&text, "%d bits of ", left);
            text_format(&text, "%d.%c", target, "rgba"[component]);
        }
    }
    return text.size ? text.at
           : any     ? "no space is left"
           : words   ? "no target has an integer format"
                     : "no target has a float format";
}

static void check_capacity(Checker *k, int number, Tree *const *trees)
{
    Placement placement;
    const FieldRow *fault = layout_allocate(k->row, number, &placement);
    if (!fault)
        return;
    const bool words = encoding_table[fault->encoding].words;
    Text encoding = text_new(k->session->arena), size = text_new(k->session->arena);
    layout_put_encoding(&encoding, fault);
    text_format(&size, words ? "%d bits of one word" : "%d components of one target",
                field_size(fault));
    k->fine = diag_add(k->session, trees[fault - k->row->cases[number].fields]->span,
                       DIAG_field_full, encoding.at, slot_table[fault->source[0].slot].name,
                       size.at, left_text(k, &placement, words));
}

static void check_cases(Checker *k, const Tree *file)
{
    if ((layout_case_bits(k->row) || k->row->further_count) &&
        !format_table[k->row->formats[0]].words)
        k->fine = diag_add(k->session, tree_find(file, "targets")->value->span, DIAG_case_words);
}

bool layout_check(Session *session, const LayoutRow *row, const Tree *file,
                  Tree *const *const *trees)
{
    Checker k = {session, row, true};
    for (int number = 0; number < row->case_count; number++) {
        for (int i = 0; i < row->cases[number].field_count; i++) {
            check_groups(&k, &row->cases[number].fields[i], trees[number][i]->span);
            check_meaning(&k, &row->cases[number].fields[i], trees[number][i]->span);
        }
        check_components(&k, &row->cases[number], trees[number]);
    }
    check_cases(&k, file);
    for (int number = 0; number < row->case_count && k.fine; number++)
        check_capacity(&k, number, trees[number]);
    return k.fine;
}
