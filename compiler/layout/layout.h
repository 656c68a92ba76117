/* Where a layout's fields lie: each group of lanes that an encoding takes is one piece of a render
 * target. */
#ifndef MATC_LAYOUT_H
#define MATC_LAYOUT_H
#include "compiler/base/text.h"
#include "grammar/layout_tables.h"

enum { MOST_PIECES = 128 };

typedef struct {
    const FieldRow *field;
    int first, count; /* its lanes, among the field's sources */
    int target, lane; /* of the render target */
    int size;         /* lanes there; or bits, from `shift` on */
    int shift;
} Piece;

typedef struct {
    Piece pieces[MOST_PIECES]; /* in the order of the rows */
    int count;
} Placement;

/* Gives every piece of a case its place: the first target lane, or run of lanes, with room for it.
 * Places depend on the rows alone. Returns NULL, or the field that does not fit. */
const FieldRow *layout_allocate(const LayoutRow *row, int number, Placement *placement);
/* Bits that tell the cases apart, the lowest of target 0; 0 where there is but one. Those of
 * further cases stand behind them. */
int layout_case_bits(const LayoutRow *row);
/* Numbers of further cases: the first `few` have `bits`; where `more_bits` is not 0, the others
 * have the number `few` and, behind it, one of their own, counted from 0. Of 20 cases 15 have four
 * bits, 0 to 14, and five have the number 15 and three bits more. */
typedef struct {
    int bits, few, more_bits;
} Further;
Further layout_further(const LayoutRow *row);
/* Code of a case in a word: its number, and the highest bit of the last word. */
double layout_case_code(const LayoutRow *row, int number, int target, int lane);
/* The case that words were packed by, of the first target's first lane and of the last's last. */
int layout_case_of(const LayoutRow *row, uint32_t first, uint32_t last);
int layout_targets(const LayoutRow *row);
int layout_bytes(const LayoutRow *row); /* of a pixel */
/* A target of it holds words, for which GLSL 1.10 has no type. */
bool layout_has_words(const LayoutRow *row);
/* Constant value of a slot in all materials of a case; NULL: the slot is stored, or absent. */
const FixedRow *layout_case_fixed(const CaseRow *row, Slot slot);
/* Slots that unpacking the layout yields, a bit each: some case stores them, or they are fixed. */
unsigned layout_slots(const LayoutRow *row);
/* Whether unpacking the layout yields the slot. */
bool layout_has_slot(const LayoutRow *row, Slot slot);
/* At least a lane of it is stored by that case; a bit for each such slot. */
bool layout_case_has_slot(const CaseRow *row, Slot slot);
unsigned layout_case_slots(const CaseRow *row);
/* The slots of layout_slots() that are the same for all materials. */
unsigned layout_fixed_slots(const LayoutRow *row);
/* A case stores every slot of the layout that is not fixed, so that every material has one. Where
 * none does, what changes nothing need not be stored. */
bool layout_is_whole(const LayoutRow *row);
/* The slot that is not stored but the same for all materials; NULL: it is stored, or absent. */
const FixedRow *layout_fixed(const LayoutRow *row, Slot slot);
/* The lanes are all lanes of one slot, in order. */
bool piece_is_slot(const Piece *piece);
/* Its encoding is told how many bits to use. */
bool piece_takes_bits(const Piece *piece);
/* "unorm 8"; "0 to 1" */
void layout_put_encoding(Text *out, const FieldRow *field);
void layout_put_range(Text *out, const FieldRow *field);
#endif
