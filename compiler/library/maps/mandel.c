#include "compiler/library/maps/escape.h"
#include "compiler/library/reference.h"

/* The fraction is t - floor(t) everywhere; GroIMP's own is 1 at the integers up to 0, a bug that
 * is not copied. */
REFERENCE(mandel)
{
    (void)context;
    const double start[2] = {4 * fraction(args[0]) - 2, 4 * fraction(args[1]) - 2};
    result[0] = escape(start, start, args[3]);
}
