/* The rows of units.def as const arrays. */
#include "unit_table.h"
#include <math.h>
#include <stddef.h>

#define ANY              -INFINITY, INFINITY
#define RANGE(low, high) low, high

const UnitRow unit_table[UNIT_COUNT] = {
#define UNIT(id, name, range, other, factor) {name, range, other, factor},
#include "units.def"
};

/* The unit of each parameter, counted from 1; 0: none. */
static const unsigned char measures[PARAM_COUNT] = {
#define MEASURE(kind, param, unit) [P_##kind##_##param] = UNIT_##unit + 1,
#include "units.def"
};

const UnitRow *unit_of(int param)
{
    return measures[param] ? &unit_table[measures[param] - 1] : NULL;
}
