/* Generates numbers of documents: ordinary ones, and those at limits. */
#include "generate.h"
#include <math.h>

static double ordinary(Choices *c, double low, double high)
{
    static const double plain[] = {1, 0.5, 0, 2, -1, 0.25, 3, 8, -0.5, 0.1};
    double value =
        chance(c, 1, 2) ? 4 * choose_part(c) - 2 : plain[choose(c, sizeof plain / sizeof *plain)];
    return fmin(fmax(value, low), high);
}

double generate_number(Choices *c, double low, double high, bool hostile)
{
    static const double special[] = {0,    -0.,      1e-8,      -1e-8,     1e4,       -1e4,   1e6,
                                     -1e6, 1e8,      -1e8,      1e-30,     1e3,       -1e3,   16,
                                     -16,  0.9999,   1.000001,  -1e-30,    1e-40,     65536., 1e-4,
                                     100,  1 - 1e-7, 6.2831855, 1.5707964, 0.33333334};
    if (!hostile || chance(c, 1, 2))
        return ordinary(c, low, high);
    bool bounded = high < GENERATE_GREATEST && chance(c, 1, 2);
    double value = special[choose(c, sizeof special / sizeof *special)];
    if (bounded)
        value = (double[]){low, high, nextafterf((float)low, (float)high),
                           nextafterf((float)high, (float)low)}[choose(c, 4)];
    return fmin(fmax((float)value, low), high);
}
