/* Interval arithmetic for the RANGE lines of ops.def. Every result contains all values of the
 * operation on any values of its operands.
 *
 *     a = [-1, 2], b = [3, 4]:  sum [2, 6], times [-4, 8], square(a) [0, 4],
 *                               quotient(a, b) [-1/3, 2/3] */
#ifndef MATC_INTERVAL_H
#define MATC_INTERVAL_H
#include <math.h>
#include <stdbool.h>

typedef struct {
    double low, high;
} Interval;

static const Interval everything = {-INFINITY, INFINITY};

/* Relative error that GLSL allows drivers in addition to rounding. */
static const double SLACK = 1e-5;

static inline Interval between(double low, double high) { return (Interval){low, high}; }

/* Faster than fmin and fmax, which handle NaN in a call: bounds are never NaN. */
static inline double least(double a, double b) { return a < b ? a : b; }
static inline double most(double a, double b) { return a > b ? a : b; }

static inline Interval hull(Interval a, Interval b)
{
    return (Interval){least(a.low, b.low), most(a.high, b.high)};
}

/* Returns true for an interval of a single number. */
static inline bool is_point(Interval a) { return a.low == a.high && isfinite(a.low); }

static inline double product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

static inline Interval times(Interval a, Interval b)
{
    double p = product(a.low, b.low), q = product(a.low, b.high), r = product(a.high, b.low),
           s = product(a.high, b.high);
    return (Interval){least(least(p, q), least(r, s)), most(most(p, q), most(r, s))};
}

static inline Interval sum(Interval a, Interval b)
{
    Interval s = {a.low + b.low, a.high + b.high};
    return (Interval){isnan(s.low) ? -INFINITY : s.low, isnan(s.high) ? INFINITY : s.high};
}

static inline Interval negative(Interval a) { return (Interval){-a.high, -a.low}; }

static inline Interval magnitude(Interval a)
{
    double high = most(fabs(a.low), fabs(a.high));
    return (Interval){a.low <= 0 && a.high >= 0 ? 0 : least(fabs(a.low), fabs(a.high)), high};
}

static inline Interval square(Interval a) { return times(magnitude(a), magnitude(a)); }

static inline Interval quotient(Interval a, Interval b)
{
    if (!(b.low > 0 || b.high < 0))
        return everything;
    return times(a, (Interval){1 / b.high, 1 / b.low});
}

/* Returns a (1 - t) + b t; t may be outside [0, 1]. */
static inline Interval mixed_at(Interval a, Interval b, double t)
{
    return sum(times(a, (Interval){1 - t, 1 - t}), times(b, (Interval){t, t}));
}
/* The mix is linear in t for any a and b, so its extremes are at both ends of t. */
static inline Interval mixed(Interval a, Interval b, Interval t)
{
    if ((t.low >= 0 && t.high <= 1) || (is_point(a) && is_point(b) && a.low == b.low))
        return hull(a, b);
    if (isfinite(t.low) && isfinite(t.high))
        return hull(mixed_at(a, b, t.low), mixed_at(a, b, t.high));
    return sum(times(a, sum((Interval){1, 1}, negative(t))), times(b, t));
}

/* Widens bounds that a driver's implementation may exceed. */
static inline Interval loose(Interval a)
{
    return (Interval){a.low - SLACK * most(fabs(a.low), 1), a.high + SLACK * most(fabs(a.high), 1)};
}

/* Image of a non-decreasing function: from its value at the lower end to that at the upper end.
 * rising() is widened, for functions that drivers approximate. */
static inline Interval ends(double (*f)(double), Interval a)
{
    return between(f(a.low), f(a.high));
}
static inline Interval rising(double (*f)(double), Interval a) { return loose(ends(f, a)); }

static inline Interval power(Interval a, Interval b)
{
    if (!(a.low >= 0) || !(b.low >= 0))
        return everything;
    double p = pow(a.low, b.low), q = pow(a.low, b.high), r = pow(a.high, b.low),
           s = pow(a.high, b.high);
    Interval corners = {fmin(fmin(p, q), fmin(r, s)), fmax(fmax(p, q), fmax(r, s))};
    if (a.low < 1 && a.high > 1)
        corners = hull(corners, (Interval){1, 1});
    return isnan(corners.low) || isnan(corners.high) ? (Interval){0, INFINITY} : loose(corners);
}

static inline Interval remainder_of(Interval a, Interval b)
{
    if (a.low >= 0 && a.high < b.low)
        return a;
    return b.low > 0 ? (Interval){0, b.high} : everything;
}

static inline Interval both(Interval a, Interval b)
{
    return (Interval){most(a.low, b.low), least(a.high, b.high)};
}
static inline bool is_empty(Interval a) { return a.low > a.high; }
#endif
