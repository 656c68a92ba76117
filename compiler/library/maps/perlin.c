/* Perlin's improved noise with the hash of OSL and MaterialX: values and gradients in double. */
#include "compiler/library/reference.h"

/* Larger coordinates have no fraction as a float. */
static const double farthest = 16777216;

static uint32_t turned(uint32_t bits, int by) { return bits << by | bits >> (32 - by); }

/* Final mix of lookup3 (Jenkins 2006) of 2 or 3 integers; the third of 2 is 0. */
static uint32_t hash_of(const double corner[3], int count)
{
    static const int turns[] = {14, 11, 25, 16, 4, 14, 24};
    uint32_t h[3];
    for (int i = 0; i < 3; i++)
        h[i] = 0xDEADBEEFu + 13 + 4 * (uint32_t)count + (uint32_t)(int32_t)corner[i];
    /* swaps c with b, a with c, b with a, and so on */
    for (int i = 0, to = 2, from = 1; i < 7; i++) {
        h[to] = (h[to] ^ h[from]) - turned(h[from], turns[i]);
        from = to;
        to = (to + 1) % 3;
    }
    return h[2];
}

/* Gradient of a corner: two axes chosen by the hash's bits from the third on, their signs by the
 * two lowest bits; scaled as the definition requires. */
static void direction_of(const double corner[3], int count, double direction[3])
{
    static const int first[16] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
    static const int second[16] = {1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 0, 2, 0, 2};
    const uint32_t hash = hash_of(corner, count);
    const double s = hash & 1 ? -1 : 1, t = hash & 2 ? -1 : 1;
    direction[0] = direction[1] = direction[2] = 0;
    if (count == 2) {
        direction[hash >> 2 & 1] = .6616 * s;
        direction[~hash >> 2 & 1] = .6616 * 2 * t;
    } else {
        direction[first[hash & 15]] += .982 * s;
        direction[second[hash & 15]] += .982 * t;
    }
}

/* Computes the gradient, then the value, of one octave. */
static void octave(const double p[3], int count, double out[4])
{
    double cell[3], d[3], far[3], rate[3];
    out[0] = out[1] = out[2] = out[3] = 0;
    for (int i = 0; i < 3; i++) {
        const double q = i < count ? p[i] : 0;
        cell[i] = floor(q);
        d[i] = q - cell[i];
        far[i] = pow(d[i], 3) * (10 - 15 * d[i] + 6 * d[i] * d[i]);
        rate[i] = 30 * pow(d[i] * (1 - d[i]), 2);
    }
    for (int k = 0; k < 1 << count; k++) {
        double corner[3], share[3], change[3], direction[3], value = 0;
        for (int i = 0; i < 3; i++) {
            const int beyond = k >> i & 1;
            corner[i] = cell[i] + beyond;
            share[i] = beyond ? far[i] : 1 - far[i];
            change[i] = beyond ? rate[i] : -rate[i];
        }
        direction_of(corner, count, direction);
        for (int i = 0; i < 3; i++)
            value += direction[i] * (d[i] - (k >> i & 1));
        for (int i = 0; i < 3; i++)
            out[i] += share[0] * share[1] * share[2] * direction[i] +
                      value * change[i] * share[(i + 1) % 3] * share[(i + 2) % 3];
        out[3] += share[0] * share[1] * share[2] * value;
    }
}

static void fractal(const double *args, double out[4])
{
    const int octaves = whole_between(args[3], 0, REFERENCE_OCTAVES), count = args[6] < 3 ? 2 : 3;
    double q[3], strength = 1, frequency = 1;
    out[0] = out[1] = out[2] = out[3] = 0;
    for (int i = 0; i < 3; i++)
        q[i] = fmax(fmin(args[i], farthest), -farthest); /* fmin and fmax also replace NaN */
    for (int k = 0; k < octaves; k++) {
        double one[4];
        octave(q, count, one);
        for (int i = 0; i < 4; i++)
            out[i] += strength * (i < 3 ? frequency : 1) * one[i];
        strength *= args[5];
        frequency *= args[4];
        for (int i = 0; i < 3; i++)
            q[i] = fmax(fmin(q[i] * args[4], farthest), -farthest);
    }
}

REFERENCE(perlin)
{
    (void)context;
    double all[4];
    fractal(args, all);
    result[0] = all[3];
}

REFERENCE(perlinGradient)
{
    (void)context;
    fractal(args, result);
}
