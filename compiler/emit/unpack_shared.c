/* Finds, for each component of a slot, the piece that most cases share. */
#include "compiler/emit/unpack_shared.h"
#include "compiler/base/session.h"

bool unpack_takes(const Job *job, int number) { return !job->cases || job->cases >> number & 1; }

static bool same_field(const FieldRow *a, const FieldRow *b)
{
    return a->encoding == b->encoding && a->bits == b->bits && !(a->low != b->low) &&
           !(a->high != b->high);
}

static bool same_piece(const Piece *a, const Piece *b)
{
    return a->target == b->target && a->component == b->component && a->size == b->size &&
           a->shift == b->shift && a->count == b->count && same_field(a->field, b->field);
}

/* Returns true for one component of a slot, or a whole slot. A gray field is one number for all
 * components, and other pieces distribute components to several slots. */
static bool may_be_shared(const Piece *piece)
{
    return !piece->field->gray && (piece->count == 1 || piece_is_slot(piece));
}

static SlotComponent component_of(const Piece *piece) { return piece->field->source[piece->first]; }

/* Returns the piece of a component in a case; NULL: none. */
static const Piece *piece_of(const Placement *placement, SlotComponent component)
{
    for (int i = 0; i < placement->count; i++) {
        const SlotComponent own = component_of(&placement->pieces[i]);
        if (own.slot == component.slot && own.component == component.component &&
            may_be_shared(&placement->pieces[i]))
            return &placement->pieces[i];
    }
    return NULL;
}

typedef struct {
    Placement at[LIMIT_LAYOUT_CASES];
    int count;
} Placements;

/* Returns the piece that most cases have for a component, and their number. */
static int most_common(const Placements *placements, SlotComponent component, Piece *common)
{
    int most = 0;
    for (int i = 0; i < placements->count; i++) {
        const Piece *piece = piece_of(&placements->at[i], component), *other;
        int count = 0;
        for (int k = i; piece && k < placements->count; k++) {
            other = piece_of(&placements->at[k], component);
            count += other && same_piece(piece, other);
        }
        if (count > most)
            *common = *piece;
        most = count > most ? count : most;
    }
    return most;
}

/* Counts the cases without the slot, which must reset it if it is shared. */
static int lacking(const Job *job, Slot slot)
{
    int count = 0;
    for (int i = 0; i < job->layout->case_count; i++)
        count += unpack_takes(job, i) && !layout_case_has_slot(&job->layout->cases[i], slot);
    return count;
}

UnpackShared unpack_shared(const Job *job)
{
    UnpackShared shared = {.has = {{false}}};
    Placements placements;
    placements.count = 0;
    for (int i = 0; i < job->layout->case_count && placements.count < LIMIT_LAYOUT_CASES; i++)
        if (unpack_takes(job, i))
            layout_allocate(job->layout, i, &placements.at[placements.count++]);
    for (int slot = 0; slot < SLOT_COUNT && placements.count > 1; slot++)
        for (int component = 0; component < type_table[slot_table[slot].type].components;
             component++) {
            const SlotComponent of = {(Slot)slot, component};
            const int count = most_common(&placements, of, &shared.pieces[slot][component]);
            shared.has[slot][component] = count - 1 > lacking(job, (Slot)slot);
        }
    return shared;
}

bool unpack_shares(const UnpackShared *shared, Slot slot)
{
    bool any = false;
    for (int component = 0; component < FIELD_COMPONENTS; component++)
        any |= shared->has[slot][component];
    return any;
}

bool unpack_is_shared(const UnpackShared *shared, const Piece *piece)
{
    const SlotComponent component = component_of(piece);
    return shared->has[component.slot][component.component] && may_be_shared(piece) &&
           same_piece(&shared->pieces[component.slot][component.component], piece);
}
