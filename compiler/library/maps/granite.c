#include "compiler/library/reference.h"
#include <stddef.h>

REFERENCE(granite)
{
    ReferenceNoise noise = ((const ReferenceContext *)context)->noise;
    double sum = 0;
    for (int k = 0; k < 6; k++) {
        double scale = ldexp(4, k);
        const double q[3] = {scale * args[0], scale * args[1], scale * args[2]};
        sum += ldexp(fabs(clamp(2 * reference_lattice(noise, q, NULL), -1, 1)) - .5, -k);
    }
    result[0] = sum;
}
