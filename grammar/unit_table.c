/* The rows of units.def as const arrays. */
#include "unit_table.h"
#include <math.h>
#include <stddef.h>

#define ANY -INFINITY, INFINITY
#define RANGE(low, high) low, high

const UnitRow unit_table[UNIT_COUNT] = {
#define UNIT(id, name, range, other, factor) {name, range, other, factor},
#include "units.def"
};

typedef struct {
    int param;
    Unit unit;
} Measure;
static const Measure measures[] = {
#define MEASURE(kind, param, unit) {P_##kind##_##param, UNIT_##unit},
#include "units.def"
};

const UnitRow *unit_of(int param)
{
    for (size_t i = 0; i < sizeof measures / sizeof *measures; i++)
        if (measures[i].param == param)
            return &unit_table[measures[i].unit];
    return NULL;
}
