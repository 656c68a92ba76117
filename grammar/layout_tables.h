/* Layouts of the G-buffer as enums and const arrays: formats of targets, encodings of slots, the
 * rows that join them, and how exact slots are kept. */
#ifndef MATC_LAYOUT_TABLES_H
#define MATC_LAYOUT_TABLES_H
#include "tables.h"

typedef enum {
    FORMAT_none, /* ends a list of formats */
#define FORMAT(name, lanes, bits, words, doc) FORMAT_##name,
#include "formats.def"
    FORMAT_COUNT
} Format;
typedef struct {
    const char *name;
    int lanes, bits; /* bits of a lane */
    bool words;      /* whole numbers, not floats */
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
    int pack;           /* a Function, or FN_none */
    const char *unpack; /* a chunk, "" for none */
    ErrorUnit unit;
    const char *doc;
} EncodingRow;
extern const EncodingRow encoding_table[ENCODING_COUNT];

enum { FIELD_LANES = 4, LAYOUT_TARGETS = 8 };
typedef struct {
    Slot slot;
    int lane;
} SlotLane;
typedef struct {
    Encoding encoding;
    int bits;
    int count; /* lanes that it stores */
    SlotLane source[FIELD_LANES];
    bool gray; /* the one lane that it stores is that of all lanes of its slot */
    /* what is stored, where the encoding takes a range; both 0: as the encoding has it */
    double low, high;
} FieldRow;
/* Properties of a field, by its bits and range. */
int field_size(const FieldRow *field);     /* of a group: lanes of a float target, or bits */
double field_error(const FieldRow *field); /* in the encoding's unit */
double field_low(const FieldRow *field);
double field_high(const FieldRow *field);
bool field_has_range(const FieldRow *field);
/* The encoding is of numbers in [0, 1] in words, which another range can be taken to. */
bool encoding_takes_range(Encoding encoding);

typedef enum {
#define LAYOUT(name, ...) LAYOUT_##name,
#include "layouts.def"
    LAYOUT_COUNT
} Layout;
/* A slot that is the same for all materials: it is not stored, and comes back all the same. */
typedef struct {
    Slot slot;
    double value[FIELD_LANES];
} FixedRow;
/* The fields of a material that has only some of the slots. */
typedef struct {
    const FieldRow *fields;
    int field_count;
    const char *doc;
    const FixedRow *fixed; /* what all materials of the case have the same of */
    int fixed_count;
} CaseRow;
/* A user's own layout is such a row too. */
typedef struct {
    const char *name, *doc;
    Format formats[LAYOUT_TARGETS + 1]; /* of its targets, then FORMAT_none */
    const CaseRow *cases;
    int case_count;
    const FixedRow *fixed;
    int fixed_count;
    /* of the cases, the last ones: they have number 0, and the highest bit of the last word */
    int further_count;
} LayoutRow;
extern const LayoutRow layout_table[LAYOUT_COUNT];

/* How exact a slot is kept where nobody says: classes.def. */
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
    double error; /* at most */
    const char *doc;
} ErrorClassRow;
extern const ErrorClassRow class_table[CLASS_COUNT];
typedef struct {
    ErrorClass kind, above; /* up to 1, and beyond */
    /* a bit for each slot without all of which it changes nothing; 0: it always matters */
    unsigned matters;
} SlotClassRow;
extern const SlotClassRow slot_class_table[SLOT_COUNT];
#endif
