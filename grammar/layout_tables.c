/* The rows of formats.def, encodings.def, layouts.def and classes.def as const arrays, and the
 * properties of fields. */
#include "layout_tables.h"
#include <math.h>
#include <stddef.h>

const FormatRow format_table[FORMAT_COUNT] = {
    [FORMAT_none] = {"", 0, 0, false, ""},
#define FORMAT(name, components, bits, words, doc) {#name, components, bits, words, doc},
#include "formats.def"
};

#define IN_FLOATS false
#define IN_WORDS  true
const EncodingRow encoding_table[ENCODING_COUNT] = {
#define ENCODING(code, store, components, text)                                                    \
    [ENCODING_##code].name = #code, [ENCODING_##code].words = IN_##store,                          \
    [ENCODING_##code].takes = components, [ENCODING_##code].doc = text,
#define BITS(code, size, at_least, at_most)                                                        \
    [ENCODING_##code].least = at_least, [ENCODING_##code].most = at_most,
#define CODE(code, to, from) [ENCODING_##code].pack = FN_##to, [ENCODING_##code].unpack = from,

#define ERROR(code, error_unit, error) [ENCODING_##code].unit = UNIT_##error_unit,
#include "encodings.def"
};
enum {
    ENCODING_LINES = 0
#define BITS(...)   +1
#define STORES(...) +1
#define CODE(...)   +1
#define ERROR(...)  +1
#include "encodings.def"
};
_Static_assert((int)ENCODING_LINES == 4 * (int)ENCODING_COUNT,
               "encodings.def has every line below every encoding");

/* Evaluates the columns of encodings.def that depend on a field's bits. */
int field_size(const FieldRow *field)
{
    const int n = field->count, b = field->bits;
    (void)n, (void)b;
    switch (field->encoding) {
#define BITS(name, size, least, most)                                                              \
    case ENCODING_##name:                                                                          \
        return size;
#include "encodings.def"
    default:
        return 0;
    }
}

/* Returns the error of the encoding itself, without range. */
static double encoding_error(const FieldRow *field)
{
    const double b = field->bits;
    (void)b;
    switch (field->encoding) {
#define ERROR(name, unit, error)                                                                   \
    case ENCODING_##name:                                                                          \
        return error;
#include "encodings.def"
    default:
        return 0;
    }
}

static double encoding_low(Encoding encoding)
{
    switch (encoding) {
#define STORES(name, low, high)                                                                    \
    case ENCODING_##name:                                                                          \
        return low;
#include "encodings.def"
    default:
        return 0;
    }
}

static double encoding_high(Encoding encoding, double b)
{
    (void)b;
    switch (encoding) {
#define STORES(name, low, high)                                                                    \
    case ENCODING_##name:                                                                          \
        return high;
#include "encodings.def"
    default:
        return 0;
    }
}

bool encoding_takes_range(Encoding encoding)
{
    const EncodingRow *row = &encoding_table[encoding];
    return row->words && row->unit == UNIT_absolute && encoding_low(encoding) == 0 &&
           encoding_high(encoding, 0) == 1;
}

bool field_has_range(const FieldRow *field) { return field->low != 0 || field->high != 0; }

double field_low(const FieldRow *field)
{
    return field_has_range(field) ? field->low : encoding_low(field->encoding);
}

double field_high(const FieldRow *field)
{
    return field_has_range(field) ? field->high : encoding_high(field->encoding, field->bits);
}

/* Returns the error of a field with a range: the encoding's error scaled to the range, plus the
 * rounding of floats in the conversions to [0, 1] and back. */
double field_error(const FieldRow *field)
{
    const double rounding = 0x1p-22;
    if (!field_has_range(field))
        return encoding_error(field);
    return encoding_error(field) * (field->high - field->low) +
           rounding * fmax(fabs(field->low), fabs(field->high));
}

static const FieldRow field_table[] = {
#define FIELD(layout, encoding, bits, slot, from, count)                                           \
    {ENCODING_##encoding,                                                                          \
     bits,                                                                                         \
     count,                                                                                        \
     {{SLOT_##slot, from},                                                                         \
      {SLOT_##slot, from + 1},                                                                     \
      {SLOT_##slot, from + 2},                                                                     \
      {SLOT_##slot, from + 3}},                                                                    \
     false,                                                                                        \
     0,                                                                                            \
     0},
#define SPAN(layout, encoding, bits, slot, from, count, low, high)                                 \
    {ENCODING_##encoding,                                                                          \
     bits,                                                                                         \
     count,                                                                                        \
     {{SLOT_##slot, from},                                                                         \
      {SLOT_##slot, from + 1},                                                                     \
      {SLOT_##slot, from + 2},                                                                     \
      {SLOT_##slot, from + 3}},                                                                    \
     false,                                                                                        \
     low,                                                                                          \
     high},
#define COMPONENT(slot, component)         SLOT_##slot, component
#define PAIR(layout, encoding, bits, a, b) {ENCODING_##encoding, bits, 2, {{a}, {b}}, false, 0, 0},
#include "layouts.def"
#undef COMPONENT
};

/* Index ranges of fields, as for parameters: LAYOUT begins the first case, CASE another one.
 * Rows have unique numbers. */
#define PASTE(a, b)  a##b
#define UNIQUE(a, b) PASTE(a, b)
enum {
#define LAYOUT(name, doc, ...) CASE(name, first, doc)
#define CASE(layout, name, doc)                                                                    \
    FIELDS_##layout##_##name, FIELDS_BACK_##layout##_##name = FIELDS_##layout##_##name - 1,
#define FIELD(...) UNIQUE(FIELD_NUMBER_, __COUNTER__),
#define PAIR(...)  FIELD()
#include "layouts.def"
};
enum {
    CASES_BEGIN = -1
#define LAYOUT(name, doc, ...)  CASE(name, first, doc)
#define CASE(layout, name, doc) , FIELD_COUNT_##layout##_##name = 0
#define FIELD(...)              +1
#define PAIR(...)               +1
#include "layouts.def"
};

/* Constant slots of all cases, ended by a row of SLOT_COUNT. */
static const FixedRow given_table[] = {
#define GIVEN(layout, slot, value) {SLOT_##slot, {value, value, value, value}},
#include "layouts.def"
    {SLOT_COUNT, {0}}};
enum {
#define LAYOUT(name, doc, ...) CASE(name, first, doc)
#define CASE(layout, name, doc)                                                                    \
    GIVENS_##layout##_##name, GIVENS_BACK_##layout##_##name = GIVENS_##layout##_##name - 1,
#define GIVEN(...) UNIQUE(GIVEN_NUMBER_, __COUNTER__),
#include "layouts.def"
};
enum {
    GIVENS_BEGIN = -1
#define LAYOUT(name, doc, ...)  CASE(name, first, doc)
#define CASE(layout, name, doc) , GIVEN_COUNT_##layout##_##name = 0
#define GIVEN(...)              +1
#include "layouts.def"
};

static const CaseRow case_table[] = {
#define LAYOUT(name, doc, ...) CASE(name, first, doc)
#define CASE(layout, name, doc)                                                                    \
    {&field_table[FIELDS_##layout##_##name], FIELD_COUNT_##layout##_##name, doc,                   \
     &given_table[GIVENS_##layout##_##name], GIVEN_COUNT_##layout##_##name},
#include "layouts.def"
};
enum {
#define LAYOUT(name, ...)       CASES_##name,
#define CASE(layout, name, doc) CASE_##layout##_##name,
#include "layouts.def"
};
enum {
    LAYOUTS_BEGIN = -1
#define LAYOUT(name, ...) , CASE_COUNT_##name = 1
#define CASE(...)         +1
#include "layouts.def"
};

enum {
    FURTHER_BEGIN = -1
#define LAYOUT(name, ...) , FURTHER_COUNT_##name = 0
#define CASE(...)
#define FURTHER(...) +1
#include "layouts.def"
};

const LayoutRow layout_table[LAYOUT_COUNT] = {
#define LAYOUT(name, doc, ...)                                                                     \
    {#name, doc, {__VA_ARGS__},       &case_table[CASES_##name], CASE_COUNT_##name,                \
     NULL,  0,   FURTHER_COUNT_##name},
#include "layouts.def"
};

const ErrorClassRow class_table[CLASS_COUNT] = {
#define ERROR_CLASS(name, unit, error, doc) {#name, CLASS_UNIT_##unit, error, doc},
#include "classes.def"
};

const SlotClassRow slot_class_table[SLOT_COUNT] = {
#define ONE(slot) 1u << SLOT_##slot
#define SLOT_CLASS(slot, kind, above, matters)                                                     \
    [SLOT_##slot] = {CLASS_##kind, CLASS_##above, matters},
#include "classes.def"
};
