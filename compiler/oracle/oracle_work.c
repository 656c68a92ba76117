/* Work of the oracle for a value, in steps of some 5 ns. The limit applies to the work, not to
 * the number of values: a Blend of 100,000 items or a fractal of 1,000 steps under four filters
 * has few values, but takes hours.
 *
 * Smooth3D over VolumeTurbulence with 10 octaves (300 operations are for 5): 27 points, each
 * with 3 values of 100 steps and one call of 3 * 300 * 10 / 5, 56,700 in total. */
#include "compiler/oracle/oracle_maps.h"
#include "compiler/library/references.h"

enum {
    USUAL_COUNT = 5, /* octaves or steps that a function's cost in the tables assumes */
    MAX_COUNTED = 1000
};

void oracle_spend(const Environment *environment, double steps)
{
    environment->oracle->work += steps;
}

double oracle_work(const Oracle *oracle) { return oracle->work; }
bool oracle_spent(const Oracle *oracle) { return oracle->work > LIMIT_WORK; }

/* Returns the repetition count of a library function, which is its only integer argument. */
static double count_of(int function, const double *args)
{
    static const int components[] = {['2'] = 2, ['3'] = 3, ['4'] = 4, ['f'] = 1, ['s'] = 1};
    for (const char *letter = function_arguments(function); *letter; letter++) {
        if (*letter == 'i')
            return clamp(*args, USUAL_COUNT, MAX_COUNTED);
        args += components[(int)*letter];
    }
    return USUAL_COUNT;
}

void oracle_call(const Environment *environment, int function, const double *args, double *result)
{
    oracle_spend(environment,
                 CALL_WORK * function_row(function)->cost * count_of(function, args) / USUAL_COUNT);
    reference_of(function)(&environment->oracle->context, args, result);
}
