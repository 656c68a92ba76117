/* Allocates the fields of a layout in the render targets. */
#include "compiler/layout/layout.h"
#include <math.h>
#include <string.h>

/* Used bits of each component of the targets. Fields are only appended. */
typedef struct {
    int taken[LAYOUT_TARGETS][FIELD_COMPONENTS];
    bool marked; /* the highest bit of the last word is used, too */
} Capacity;

int layout_targets(const LayoutRow *row)
{
    int count = 0;
    while (row->formats[count] != FORMAT_none)
        count++;
    return count;
}

int layout_bytes(const LayoutRow *row)
{
    int bits = 0;
    for (int i = 0; i < layout_targets(row); i++)
        bits += format_table[row->formats[i]].components * format_table[row->formats[i]].bits;
    return bits / 8;
}

bool layout_has_words(const LayoutRow *row)
{
    for (int i = 0; i < layout_targets(row); i++)
        if (format_table[row->formats[i]].words)
            return true;
    return false;
}

bool layout_case_has_slot(const CaseRow *row, Slot slot)
{
    for (int i = 0; i < row->field_count; i++)
        for (int k = 0; k < row->fields[i].count; k++)
            if (row->fields[i].source[k].slot == slot)
                return true;
    return false;
}

const FixedRow *layout_fixed(const LayoutRow *row, Slot slot)
{
    for (int i = 0; i < row->fixed_count; i++)
        if (row->fixed[i].slot == slot)
            return &row->fixed[i];
    return NULL;
}

const FixedRow *layout_case_fixed(const CaseRow *row, Slot slot)
{
    for (int i = 0; i < row->fixed_count; i++)
        if (row->fixed[i].slot == slot)
            return &row->fixed[i];
    return NULL;
}

bool layout_has_slot(const LayoutRow *row, Slot slot) { return layout_slots(row) >> slot & 1; }

static int plain_count(const LayoutRow *row) { return row->case_count - row->further_count; }

unsigned layout_case_slots(const CaseRow *row)
{
    unsigned slots = 0;
    for (int i = 0; i < row->field_count; i++)
        for (int k = 0; k < row->fields[i].count; k++)
            slots |= 1u << row->fields[i].source[k].slot;
    return slots;
}

static unsigned fixed_slots(const FixedRow *fixed, int count)
{
    unsigned slots = 0;
    for (int i = 0; i < count; i++)
        slots |= 1u << fixed[i].slot;
    return slots;
}

unsigned layout_fixed_slots(const LayoutRow *row)
{
    return fixed_slots(row->fixed, row->fixed_count);
}

unsigned layout_slots(const LayoutRow *row)
{
    unsigned slots = layout_fixed_slots(row);
    for (int i = 0; i < row->case_count; i++)
        slots |= layout_case_slots(&row->cases[i]) |
                 fixed_slots(row->cases[i].fixed, row->cases[i].fixed_count);
    return slots;
}

bool layout_is_whole(const LayoutRow *row)
{
    unsigned all = 0, most = 0;
    for (int i = 0; i < plain_count(row); i++)
        all |= layout_case_slots(&row->cases[i]);
    for (int i = 0; i < plain_count(row) && most != all; i++)
        most = layout_case_slots(&row->cases[i]);
    return plain_count(row) && most == all;
}

static int bits_for(int count)
{
    int bits = 0;
    while (1 << bits < count)
        bits++;
    return bits;
}

/* Numbers of further cases have at most four bits. The greatest of them is an escape code,
 * followed by additional bits. */
enum { SHORT_BITS = 4, SHORT_NUMBERS = 1 << SHORT_BITS, ESCAPE = SHORT_NUMBERS - 1 };

int layout_case_bits(const LayoutRow *row) { return bits_for(plain_count(row)); }

Further layout_further(const LayoutRow *row)
{
    if (row->further_count <= SHORT_NUMBERS)
        return (Further){bits_for(row->further_count), row->further_count, 0};
    return (Further){SHORT_BITS, ESCAPE, bits_for(row->further_count - ESCAPE)};
}

/* Returns the code of a further case, which follows case number 0, and its number of bits. */
static unsigned further_code(const LayoutRow *row, int further, int *bits)
{
    const Further numbers = layout_further(row);
    const bool more = further >= numbers.few;
    *bits = numbers.bits + (more ? numbers.more_bits : 0);
    return (unsigned)(more ? ESCAPE | (further - numbers.few) << SHORT_BITS : further);
}

static bool is_last_word(const LayoutRow *row, int target, int component)
{
    return target + 1 == layout_targets(row) &&
           component + 1 == format_table[row->formats[target]].components;
}

double layout_case_code(const LayoutRow *row, int number, int target, int component)
{
    const int further = number - plain_count(row);
    const bool marked = further >= 0 && is_last_word(row, target, component);
    const double mark = marked ? ldexp(1, format_table[row->formats[target]].bits - 1) : 0;
    int bits;
    if (target || component)
        return mark;
    return mark +
           (further < 0 ? number : ldexp(further_code(row, further, &bits), layout_case_bits(row)));
}

int layout_case_of(const LayoutRow *row, uint32_t first, uint32_t last)
{
    const int number = (int)(first & ((1u << layout_case_bits(row)) - 1));
    const int bits = format_table[row->formats[layout_targets(row) - 1]].bits;
    if (!row->further_count || number || !(last >> (bits - 1) & 1))
        return number;
    const Further numbers = layout_further(row);
    const uint32_t code = first >> layout_case_bits(row);
    const int further = (int)(code & ((1u << numbers.bits) - 1));
    return plain_count(row) +
           (further < numbers.few || !numbers.more_bits
                ? further
                : ESCAPE + (int)(code >> SHORT_BITS & ((1u << numbers.more_bits) - 1)));
}

bool piece_is_slot(const Piece *piece)
{
    const SlotComponent *source = &piece->field->source[piece->first];
    for (int i = 0; i < piece->count; i++)
        if (source[i].slot != source[0].slot || source[i].component != i)
            return false;
    return piece->count == type_table[slot_table[source[0].slot].type].components;
}

bool piece_takes_bits(const Piece *piece)
{
    int pack = encoding_table[piece->field->encoding].pack;
    const char *arguments = pack == FN_none ? "" : function_arguments(pack);
    return strchr(arguments, 'i') != NULL;
}

/* Returns true if the adjacent components are free. */
static bool fits_components(const Capacity *capacity, const FormatRow *format, const Piece *piece)
{
    for (int i = 0; i < piece->size; i++)
        if (piece->component + i >= format->components ||
            capacity->taken[piece->target][piece->component + i])
            return false;
    return true;
}

static bool fits(const Capacity *capacity, const LayoutRow *row, const Piece *piece)
{
    const FormatRow *format = &format_table[row->formats[piece->target]];
    if (format->words != encoding_table[piece->field->encoding].words)
        return false;
    const int mark = capacity->marked && is_last_word(row, piece->target, piece->component);
    return format->words ? capacity->taken[piece->target][piece->component] + piece->size <=
                               format->bits - mark
                         : fits_components(capacity, format, piece);
}

static bool find_capacity(Capacity *capacity, const LayoutRow *row, Piece *piece)
{
    for (piece->target = 0; piece->target < layout_targets(row); piece->target++) {
        const FormatRow *format = &format_table[row->formats[piece->target]];
        for (piece->component = 0; piece->component < format->components; piece->component++) {
            if (!fits(capacity, row, piece))
                continue;
            int *taken = &capacity->taken[piece->target][piece->component];
            piece->shift = format->words ? *taken : 0;
            *taken += format->words ? piece->size : 0;
            for (int i = 0; !format->words && i < piece->size; i++)
                taken[i] = format->bits;
            return true;
        }
    }
    return false;
}

/* Checks that the bits are within the encoding's limits, and that its groups use all components. */
static bool is_sound(const FieldRow *field)
{
    const EncodingRow *encoding = &encoding_table[field->encoding];
    return field->count >= 1 && field->count <= FIELD_COMPONENTS &&
           field->bits >= encoding->least && field->bits <= encoding->most &&
           (!encoding->takes || field->count % encoding->takes == 0);
}

const FieldRow *layout_allocate(const LayoutRow *row, int number, Placement *placement)
{
    const CaseRow *fields = &row->cases[number];
    const bool further = number >= plain_count(row);
    int behind = 0;
    if (further)
        further_code(row, number - plain_count(row), &behind);
    Capacity capacity = {.taken = {{layout_case_bits(row) + behind}}};
    capacity.marked = further || (row->further_count && number == 0);
    placement->count = 0;
    if ((layout_case_bits(row) || row->further_count) && !format_table[row->formats[0]].words)
        return &fields->fields[0]; /* no word has enough free bits for the case number */
    for (int i = 0; i < fields->field_count; i++) {
        const FieldRow *field = &fields->fields[i];
        int takes = encoding_table[field->encoding].takes ? encoding_table[field->encoding].takes
                                                          : field->count;
        if (!is_sound(field))
            return field;
        for (int first = 0; first < field->count; first += takes) {
            Piece piece = {
                .field = field, .first = first, .count = takes, .size = field_size(field)};
            if (placement->count == MAX_PIECES || !find_capacity(&capacity, row, &piece))
                return field;
            placement->pieces[placement->count++] = piece;
        }
    }
    return NULL;
}

void layout_put_encoding(Text *out, const FieldRow *field)
{
    const EncodingRow *encoding = &encoding_table[field->encoding];
    text_put(out, encoding->name);
    if (encoding->least != encoding->most)
        text_format(out, " %d", field->bits);
}

void layout_put_range(Text *out, const FieldRow *field)
{
    text_rounded(out, field_low(field), 6);
    text_put(out, " to ");
    text_rounded(out, field_high(field), 6);
}
