/* MaterialX's cell noise and Worley noise: Jenkins' lookup3 of any count of numbers, in
 * integers, and distances in double. */
#include "compiler/library/reference.h"

/* Larger coordinates have no fraction as a float. */
static const double farthest = 16777216;

static uint32_t turned(uint32_t bits, int by) { return bits << by | bits >> (32 - by); }

/* Returns the hash over 2^32 - 1: mixes all but the last three numbers in threes, then applies
 * the final mix to the last three. */
static double hashed(const double *numbers, int count)
{
    static const int mixed[] = {4, 6, 8, 16, 19, 4}, last[] = {14, 11, 25, 16, 4, 14, 24};
    uint32_t h[3];
    for (int i = 0; i < 3; i++)
        h[i] = 0xDEADBEEFu + 13 + 4 * (uint32_t)count;
    for (; count > 3; count -= 3, numbers += 3) {
        for (int i = 0; i < 3; i++)
            h[i] += (uint32_t)(int32_t)numbers[i];
        /* swaps a with c and b, then b with a and c, then c with b and a */
        for (int i = 0; i < 6; i++) {
            uint32_t *to = &h[i % 3], *by = &h[(i + 2) % 3];
            *to = (*to - *by) ^ turned(*by, mixed[i]);
            *by += h[(i + 1) % 3];
        }
    }
    for (int i = 0; i < count; i++)
        h[i] += (uint32_t)(int32_t)numbers[i];
    for (int i = 0, to = 2, from = 1; i < 7; i++) {
        h[to] = (h[to] ^ h[from]) - turned(h[from], last[i]);
        from = to;
        to = (to + 1) % 3;
    }
    return h[2] / 4294967295.;
}

static void cell_of(const double *p, int count, double cell[3])
{
    for (int i = 0; i < 3; i++)
        cell[i] = i < count ? floor(fmax(fmin(p[i], farthest), -farthest)) : 0;
}

REFERENCE(cellNoise)
{
    (void)context;
    double cell[3];
    const int count = args[3] < 3 ? 2 : 3;
    cell_of(args, count, cell);
    result[0] = hashed(cell, count);
}

/* Computes the gradient, then the value. */
static void nearest(const double *args, double out[4])
{
    const int count = args[5] < 3 ? 2 : 3;
    double cell[3], least = INFINITY;
    cell_of(args, count, cell);
    for (int k = 0; k < (count < 3 ? 9 : 27); k++) {
        double numbers[4] = {0}, away[3] = {0}, square = 0;
        const int beside[3] = {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
        for (int i = 0; i < count; i++)
            numbers[i] = cell[i] + beside[i];
        for (int i = 0; i < count; i++) {
            numbers[count] = i;
            away[i] = fmax(fmin(args[i], farthest), -farthest) - numbers[i] -
                      (hashed(numbers, count + 1) - .5) * args[3] - .5;
            square += away[i] * away[i];
        }
        if (square >= least)
            continue;
        least = square;
        out[3] = args[4] > 0 ? hashed(numbers, count) : sqrt(square);
        for (int i = 0; i < 3; i++)
            out[i] = args[4] > 0 ? 0 : away[i] / fmax(sqrt(square), 1e-6);
    }
}

REFERENCE(worley)
{
    (void)context;
    double all[4];
    nearest(args, all);
    result[0] = all[3];
}

REFERENCE(worleyGradient)
{
    (void)context;
    nearest(args, result);
}
