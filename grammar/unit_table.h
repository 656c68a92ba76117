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
    const char *name;  /* "" of a share */
    double low, high;  /* what is usual; not finite: anything is */
    const char *other; /* in which a number beyond may be thought; "": none */
    double factor;     /* from that to this */
} UnitRow;
extern const UnitRow unit_table[UNIT_COUNT];
/* Unit of a parameter by its row of param_table; NULL: it has none. */
const UnitRow *unit_of(int param);
#endif
