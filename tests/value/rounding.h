/* What rounding may make of a slot's value: its program as IR, each of whose operations errs at
 * random as much as it may. A point's own bound, for values that no bound of a map can hold: the
 * slope of a picture amplifies what its coordinate was rounded by, as often as the picture is
 * repeated there. */
#ifndef MATC_VALUE_ROUNDING_H
#define MATC_VALUE_ROUNDING_H
#include "tests/value/documents.h"
#include "tests/value/points.h"

/* A drawn number, and what it should be. */
typedef struct {
    Slot slot;
    int lane;
    const Point *point;
    bool front;
    const Hull *hull;
    double number;
} DrawnNumber;

/* What rounding may excuse, in units of max(1, |value|) outside of the hull, and how many numbers
 * of a draw. A program whose every operation is right may still lose what it computes: a step that
 * is lost beside a coordinate, a difference of great numbers. That is a fault, and it is off by
 * more, or nearly everywhere. Of the seeds 0 ... 4 of test_value 7.4e-5 is the most, and 8 numbers
 * of 1920. */
#define ROUNDING_MOST 1.5e-4
enum { ROUNDING_NUMBERS = 16 };
/* How far the number lies outside of what rounding makes of the program that the options choose, in
 * units of max(1, |value|). No excuse have a number ROUNDING_MOST outside of the hull, and a
 * program that has another value than the oracle without any rounding, by more than `bound` outside
 * of the hull: INFINITY. */
double rounding_miss(Document *document, int material, const MatcOptions *options,
                     const DrawnNumber *drawn, double bound);
#endif
