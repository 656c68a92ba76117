/* Allocation of a layout's fields: each group of components that an encoding takes is one piece
 * of a render target. */
#ifndef MATC_LAYOUT_H
#define MATC_LAYOUT_H
#include "compiler/base/text.h"
#include "grammar/layout_tables.h"

enum { MAX_PIECES = 128 };

typedef struct {
    const FieldRow *field;
    int first, count;      /* range of components in the field's sources */
    int target, component; /* render target, and component of the target */
    int size;              /* number of components; in a word target number of bits */
    int shift;
} Piece;

typedef struct {
    Piece pieces[MAX_PIECES]; /* pieces in the order of the rows */
    int count;
} Placement;

/* Allocates every piece of a case in the first target component, or run of components, with
 * enough free bits. The result depends on the rows only. Returns NULL, or the field that does
 * not fit. */
const FieldRow *layout_allocate(const LayoutRow *row, int number, Placement *placement);
/* Returns the number of low bits in target 0 that hold the case number; 0 for a single case. The
 * numbers of further cases follow these bits. */
int layout_case_bits(const LayoutRow *row);
/* Numbering of further cases: the first `few` numbers have `bits` bits. If `more_bits` is not 0,
 * other cases have the escape number `few`, followed by a second number, counted from 0.
 * Example: of 20 cases 15 have the numbers 0 to 14 in four bits; five have the number 15 and
 * three more bits. */
typedef struct {
    int bits, few, more_bits;
} Further;
Further layout_further(const LayoutRow *row);
/* Returns a case's bits in a word: its number, and the highest bit of the last word. */
double layout_case_code(const LayoutRow *row, int number, int target, int component);
/* Decodes the case from the first target's first word and the last target's last word. */
int layout_case_of(const LayoutRow *row, uint32_t first, uint32_t last);
int layout_targets(const LayoutRow *row);
int layout_bytes(const LayoutRow *row); /* Returns the bytes per pixel. */
/* Returns true if a target holds unsigned words, for which GLSL 1.10 has no type. */
bool layout_has_words(const LayoutRow *row);
/* Returns the constant value of a slot in all materials of a case; NULL: the slot is stored, or
 * absent. */
const FixedRow *layout_case_fixed(const CaseRow *row, Slot slot);
/* Returns a bit for each slot that unpacking yields: stored by some case, or constant. */
unsigned layout_slots(const LayoutRow *row);
/* Returns true if unpacking the layout yields the slot. */
bool layout_has_slot(const LayoutRow *row, Slot slot);
/* Returns true if the case stores at least one component of the slot; layout_case_slots()
 * returns a bit for each such slot. */
bool layout_case_has_slot(const CaseRow *row, Slot slot);
unsigned layout_case_slots(const CaseRow *row);
/* Returns the slots of layout_slots() that are constant for all materials. */
unsigned layout_fixed_slots(const LayoutRow *row);
/* Returns true if some case stores every slot of the layout that is not constant, so that every
 * material has a case. If no case does, slots without effect may be omitted. */
bool layout_is_whole(const LayoutRow *row);
/* Returns the constant value of a slot in all materials; NULL: the slot is stored, or absent. */
const FixedRow *layout_fixed(const LayoutRow *row, Slot slot);
/* Returns true if the piece holds all components of one slot in order. */
bool piece_is_slot(const Piece *piece);
/* Returns true if the encoding's functions take the number of bits as an argument. */
bool piece_takes_bits(const Piece *piece);
/* Writes an encoding, "unorm 8", or a range, "0 to 1". */
void layout_put_encoding(Text *out, const FieldRow *field);
void layout_put_range(Text *out, const FieldRow *field);
#endif
