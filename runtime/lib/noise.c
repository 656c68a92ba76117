/* Noise and turbulence, semantics.md 3.1 and 3.2. */
#include "runtime/reference.h"

static ReferenceNoise noise_of(const void *context) { return ((const ReferenceContext *)context)->noise; }

static double noise_at(const void *context, const double p[3], double scale)
{
    const double q[3] = {scale * p[0], scale * p[1], scale * p[2]};
    return clamp(2 * reference_lattice(noise_of(context), q), -1, 1);
}

REFERENCE(noise) { result[0] = noise_at(context, args, 1); }

REFERENCE(turbulence)
{
    int octaves = args[3] > 1 ? (int)args[3] : 1;
    double sum = 0;
    for (int k = 0; k < octaves; k++)
        sum += pow(args[5], k) * noise_at(context, args, pow(args[4], k));
    result[0] = sum;
}

REFERENCE(vectorTurbulence)
{
    int octaves = args[3] > 1 ? (int)args[3] : 1;
    double sum[3] = {0};
    for (int k = 0; k < octaves; k++) {
        double scale = pow(args[4], k), term[3];
        const double q[3] = {scale * args[0], scale * args[1], scale * args[2]};
        reference_lattice3(noise_of(context), q, term);
        for (int i = 0; i < 3; i++)
            sum[i] += pow(args[5], k) * term[i];
    }
    for (int i = 0; i < 3; i++)
        result[i] = sum[i];
}
