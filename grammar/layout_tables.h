/* Layouts of the G-buffer as enums and const arrays: formats of targets, encodings of slots, the
 * fields of layouts, and the accuracy classes of slots. */
#ifndef MATC_LAYOUT_TABLES_H
#define MATC_LAYOUT_TABLES_H
#include "tables.h"

typedef enum {
    FORMAT_none, /* terminates a list of formats */
#define FORMAT(name, components, bits, words, doc) FORMAT_##name,
#include "formats.def"
    FORMAT_COUNT
} Format;
typedef struct {
    const char *name;
    int components, bits; /* number of components, and bits of each */
    bool words;           /* components are unsigned integers, not floats */
    const char *doc;
} FormatRow;
extern const FormatRow format_table[FORMAT_COUNT];

typedef enum {
#define ENCODING(name, store, takes, doc) ENCODING_##name,
#include "encodings.def"
    ENCODING_COUNT
} Encoding;
typedef enum { UNIT_absolute, UNIT_relative, UNIT_degrees } ErrorUnit;
typedef struct {
    const char *name;
    bool words;
    int takes;
    int least, most;
    int pack;           /* packing Function; FN_none: none */
    const char *unpack; /* unpacking chunk; "": none is needed */
    ErrorUnit unit;
    const char *doc;
} EncodingRow;
extern const EncodingRow encoding_table[ENCODING_COUNT];

enum { FIELD_COMPONENTS = 4, LAYOUT_TARGETS = 8 };
typedef struct {
    Slot slot;
    int component;
} SlotComponent;
typedef struct {
    Encoding encoding;
    int bits;
    int count; /* number of stored components */
    SlotComponent source[FIELD_COMPONENTS];
    bool gray; /* one stored component serves all components of its slot */
    /* Range of the stored values, if the encoding takes a range; both 0: the encoding's own
     * range. */
    double low, high;
} FieldRow;
/* Properties of a field that depend on its bits and range. */
int field_size(const FieldRow *field);     /* Returns the size of a group: components, or bits. */
double field_error(const FieldRow *field); /* Returns the max error in the encoding's unit. */
double field_low(const FieldRow *field);
double field_high(const FieldRow *field);
bool field_has_range(const FieldRow *field);
/* Returns true for encodings of numbers in [0, 1] in words, which can be scaled to another
 * range. */
bool encoding_takes_range(Encoding encoding);

typedef enum {
#define LAYOUT(name, ...) LAYOUT_##name,
#include "layouts.def"
    LAYOUT_COUNT
} Layout;
/* A slot that is constant for all materials: it is not stored, but unpacking yields it. */
typedef struct {
    Slot slot;
    double value[FIELD_COMPONENTS];
} FixedRow;
/* The fields of a case, for materials that have only some of the slots. */
typedef struct {
    const FieldRow *fields;
    int field_count;
    const char *doc;
    const FixedRow *fixed; /* slots that are constant for all materials of the case */
    int fixed_count;
} CaseRow;
/* A layout; user-defined layouts are such rows, too. */
typedef struct {
    const char *name, *doc;
    Format formats[LAYOUT_TARGETS + 1]; /* formats of the targets, ended by FORMAT_none */
    const CaseRow *cases;
    int case_count;
    const FixedRow *fixed;
    int fixed_count;
    /* Number of further cases, the last ones: their case number is 0, and the highest bit of the
     * last word is set. */
    int further_count;
} LayoutRow;
extern const LayoutRow layout_table[LAYOUT_COUNT];

/* Default accuracy of a slot: classes.def. */
typedef enum {
#define ERROR_CLASS(name, unit, error, doc) CLASS_##name,
#include "classes.def"
    CLASS_COUNT
} ErrorClass;
typedef enum {
    CLASS_UNIT_display,
    CLASS_UNIT_relative,
    CLASS_UNIT_degrees,
    CLASS_UNIT_absolute
} ClassUnit;
typedef struct {
    const char *name;
    ClassUnit unit;
    double error; /* max error in the unit `unit` */
    const char *doc;
} ErrorClassRow;
extern const ErrorClassRow class_table[CLASS_COUNT];
typedef struct {
    ErrorClass kind, above; /* class of a slot up to 1, and of a slot above 1 */
    /* A bit for each slot of which at least one must be present for the slot to have an effect;
     * 0: always has an effect. */
    unsigned matters;
} SlotClassRow;
extern const SlotClassRow slot_class_table[SLOT_COUNT];
#endif
