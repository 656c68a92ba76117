/* The rows of units.def. */
#ifndef MATC_UNIT_TABLE_H
#define MATC_UNIT_TABLE_H
#include "tables.h"

typedef enum {
#define UNIT(id, name, range, other, factor) UNIT_##id,
#include "units.def"
    UNIT_COUNT
} Unit;
typedef struct {
    const char *name;  /* name of the unit; "" for a fraction */
    double low, high;  /* usual range; not finite: unbounded */
    const char *other; /* unit that a number outside may be in; "": none */
    double factor;     /* converts from the other unit to this one */
} UnitRow;
extern const UnitRow unit_table[UNIT_COUNT];
/* Returns the unit of a parameter, an index of param_table; NULL: none. */
const UnitRow *unit_of(int param);
#endif
