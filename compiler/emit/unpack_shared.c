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
    return a->target == b->target && a->lane == b->lane && a->size == b->size &&
           a->shift == b->shift && a->count == b->count && same_field(a->field, b->field);
}

/* True for one component of a slot, or a whole slot. A gray field is one number for all
 * components, and other pieces distribute components to several slots. */
static bool may_be_shared(const Piece *piece)
{
    return !piece->field->gray && (piece->count == 1 || piece_is_slot(piece));
}

static SlotLane lane_of(const Piece *piece) { return piece->field->source[piece->first]; }

/* Returns the piece of a component in a case, or NULL. */
static const Piece *piece_of(const Placement *placement, SlotLane lane)
{
    for (int i = 0; i < placement->count; i++) {
        const SlotLane own = lane_of(&placement->pieces[i]);
        if (own.slot == lane.slot && own.lane == lane.lane && may_be_shared(&placement->pieces[i]))
            return &placement->pieces[i];
    }
    return NULL;
}

typedef struct {
    Placement at[LIMIT_LAYOUT_CASES];
    int count;
} Placements;

/* Returns the piece that most cases have for a component, and their number. */
static int most_common(const Placements *placements, SlotLane lane, Piece *common)
{
    int most = 0;
    for (int i = 0; i < placements->count; i++) {
        const Piece *piece = piece_of(&placements->at[i], lane), *other;
        int count = 0;
        for (int k = i; piece && k < placements->count; k++) {
            other = piece_of(&placements->at[k], lane);
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
        for (int lane = 0; lane < type_table[slot_table[slot].type].lanes; lane++) {
            const SlotLane of = {(Slot)slot, lane};
            const int count = most_common(&placements, of, &shared.pieces[slot][lane]);
            shared.has[slot][lane] = count - 1 > lacking(job, (Slot)slot);
        }
    return shared;
}

bool unpack_shares(const UnpackShared *shared, Slot slot)
{
    bool any = false;
    for (int lane = 0; lane < FIELD_LANES; lane++)
        any |= shared->has[slot][lane];
    return any;
}

bool unpack_is_shared(const UnpackShared *shared, const Piece *piece)
{
    const SlotLane lane = lane_of(piece);
    return shared->has[lane.slot][lane.lane] && may_be_shared(piece) &&
           same_piece(&shared->pieces[lane.slot][lane.lane], piece);
}
