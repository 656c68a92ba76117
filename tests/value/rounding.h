/* Effect of rounding on a slot's value: its program is evaluated as IR with a random error, up
 * to its bound, in each operation. This gives a tolerance at points where no map's fixed bound
 * can hold: the slope of a picture amplifies the rounding of its coordinate by the number of
 * repetitions at the point. */
#ifndef MATC_VALUE_ROUNDING_H
#define MATC_VALUE_ROUNDING_H
#include "tests/value/documents.h"
#include "tests/value/points.h"

/* A drawn number, and its expected value. */
typedef struct {
    Slot slot;
    int component;
    const Point *point;
    bool front;
    const Hull *hull;
    double number;
} DrawnNumber;

/* Greatest error that rounding may explain, in units of max(1, |value|) outside of the hull, and
 * the number of values of a draw that may have it. A program of correct operations may still
 * lose its result: a step added to a large coordinate, a difference of large numbers. That is a
 * fault, with a larger error, or nearly everywhere. Over the seeds 0 ... 4 of test_value the
 * maximum is 7.4e-5, and 8 numbers of 1920. */
#define ROUNDING_MAX 1.5e-4
enum { ROUNDING_NUMBERS = 16 };
/* Distance of the number from the range that rounding gives for the program chosen by the
 * options, in units of max(1, |value|). INFINITY for a number ROUNDING_MAX or more outside of
 * the hull, and for a program whose value without rounding differs from the oracle by more than
 * `bound` outside of the hull. */
double rounding_miss(Document *document, int material, const MatcOptions *options,
                     const DrawnNumber *drawn, double bound);
#endif
