/* The lattice noises of semantics.md 3.1 in double precision. They differ only in the random
 * numbers at a lattice corner. */
#include "compiler/library/java_random.h"
#include "compiler/library/reference.h"
#include <pthread.h>
#include <string.h>

enum {
    PERIOD = 65536,     /* period of every noise along each axis, in cells */
    OUTPUTS = 3,        /* components of vector noise */
    NUMBERS = 4,        /* numbers per corner and output: value and gradient */
    RANDOM_COUNT = 512, /* size of GroIMP's table */
    RANDOM_STEP = 8,    /* table offset between outputs */
    PRIME = 761,        /* modulus of the float hash */
    PRIME_STEP = 17     /* constant added to a float hash before the hash is permuted again */
};
#define GROIMP_SEED   123456789
#define SIMPLEX_SCALE 71.0

typedef struct {
    double number[OUTPUTS][NUMBERS];
} Corner;

static uint16_t permutation[PERIOD];
static float
    /* wraps around: the end repeats the beginning */
    random_table[RANDOM_COUNT + NUMBERS - 1 + (OUTPUTS - 1) * RANDOM_STEP];
static pthread_once_t tables_once = PTHREAD_ONCE_INIT;

static void build_tables(void)
{
    uint64_t state = java_random(GROIMP_SEED);
    for (int i = 0; i < PERIOD; i++)
        permutation[i] = (uint16_t)i;
    for (int i = 0; i < PERIOD; i++) {
        /* Java's nextInt(2^16) returns the top 16 of 31 bits. */
        uint32_t j = java_random_bits(&state, 31) >> 15;
        uint16_t kept = permutation[i];
        permutation[i] = permutation[j];
        permutation[j] = kept;
    }
    for (int i = 0; i < RANDOM_COUNT; i++)
        random_table[i] = java_random_signed(&state);
    for (int i = RANDOM_COUNT; i < (int)(sizeof random_table / sizeof *random_table); i++)
        random_table[i] = random_table[i - RANDOM_COUNT];
}

const uint16_t *reference_permutation(void)
{
    pthread_once(&tables_once, build_tables);
    return permutation;
}

const float *reference_random_table(void)
{
    pthread_once(&tables_once, build_tables);
    return random_table;
}

static uint32_t mix_bits(uint32_t h)
{
    h = (h ^ (h >> 16)) * 0x7FEB352Du;
    h = (h ^ (h >> 15)) * 0x846CA68Bu;
    return h ^ (h >> 16);
}

/* Returns the hash as a signed number, divided by 2^31. */
static double signed_bits(uint32_t h)
{
    return (h < 0x80000000u ? (double)h : (double)h - 4294967296.0) / 2147483648.0;
}

static Corner integer_corner(const uint32_t c[3], int outputs)
{
    Corner corner;
    uint32_t h =
        mix_bits(c[0] * 0x9E3779B1u ^ c[1] * 0x85EBCA77u ^ (c[2] * 0xC2B2AE3Du + 0x165667B1u));
    for (int output = 0; output < outputs; output++) {
        for (int i = 0; i < NUMBERS; i++)
            corner.number[output][i] = signed_bits(h << 7 * i);
        h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
        h ^= h >> 16;
    }
    return corner;
}

/* Numbers of a simplex corner: the top bits of products of its hash. The value is 0. */
static Corner simplex_corner(const uint32_t c[3], int outputs)
{
    static const uint32_t factor[NUMBERS] = {0, 0xCAF4BCE3u, 0xCF612DE7u, 0x6BA88D47u};
    Corner corner;
    uint32_t h = c[0] * 0xA6F9A1C3u ^ c[1] * 0xF0729897u ^ c[2] * 0xB16E8989u;
    for (int output = 0; output < outputs; output++) {
        for (int i = 0; i < NUMBERS; i++)
            corner.number[output][i] = signed_bits(h * factor[i]);
        h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
        h ^= h >> 16;
    }
    return corner;
}

static uint32_t cube(uint32_t x) { return x * x % PRIME * x % PRIME; }

static uint32_t prime_axis(uint32_t c)
{
    uint32_t block = c / PRIME, rest = c % PRIME;
    return cube((block * (rest + 3) + rest) % PRIME);
}

static Corner float_corner(const uint32_t c[3], int outputs)
{
    static const uint32_t factor[NUMBERS] = {1, 209, 304, 373}, offset[NUMBERS] = {0, 97, 211, 523};
    Corner corner;
    uint32_t h =
        cube(cube(cube(prime_axis(c[0]) + PRIME_STEP) + prime_axis(c[1])) + prime_axis(c[2]));
    for (int output = 0; output < outputs; output++) {
        for (int i = 0; i < NUMBERS; i++)
            corner.number[output][i] =
                ((double)((h * factor[i] + offset[i]) % PRIME) - PRIME / 2) / (PRIME / 2.);
        h = cube(h + PRIME_STEP);
    }
    return corner;
}

static Corner groimp_corner(const uint32_t c[3], int outputs)
{
    Corner corner;
    const uint16_t *p = reference_permutation();
    uint32_t h = p[p[p[c[0]] ^ c[1]] ^ c[2]] % RANDOM_COUNT;
    for (int output = 0; output < outputs; output++)
        for (int i = 0; i < NUMBERS; i++)
            corner.number[output][i] =
                (double)random_table[h + (uint32_t)(RANDOM_STEP * output + i)];
    return corner;
}

/* Computes the first `outputs` outputs of a corner. */
static Corner corner_of(ReferenceNoise noise, const uint32_t c[3], int outputs)
{
    switch (noise) {
    case REFERENCE_LATTICE_FLOAT:
    case REFERENCE_SIMPLEX_FLOAT:
        return float_corner(c, outputs);
    case REFERENCE_GROIMP:
    case REFERENCE_GROIMP_FLOAT:
        return groimp_corner(c, outputs);
    case REFERENCE_SIMPLEX:
        return simplex_corner(c, outputs);
    default:
        return integer_corner(c, outputs);
    }
}

/* An integer modulo the period; 0 for infinity and NaN, which keeps the cast defined. */
static uint32_t wrap(double whole)
{
    double wrapped = whole - PERIOD * floor(whole / PERIOD);
    return wrapped >= 0 && wrapped < PERIOD ? (uint32_t)wrapped : 0;
}

/* A corner's interpolation weight at a point, and the weight's gradient. */
typedef struct {
    double value, slope[3];
} Weight;

/* Sums over corners of the first `outputs` outputs. */
typedef struct {
    int outputs;
    double value[OUTPUTS], slope[OUTPUTS][3];
} Sum;

/* Adds a corner's value-plus-gradient term times a weight, and the gradient of the product. */
static void add_corner(const Corner *corner, const double e[3], const Weight *weight, Sum *sum)
{
    for (int output = 0; output < sum->outputs; output++) {
        const double *t = corner->number[output];
        double term = t[0] / 2 + t[1] * e[0] + t[2] * e[1] + t[3] * e[2];
        sum->value[output] += weight->value * term;
        for (int axis = 0; axis < 3; axis++)
            sum->slope[output][axis] += weight->value * t[1 + axis] + weight->slope[axis] * term;
    }
}

/* Value-plus-gradient noise on the cubic lattice: weights s(t) = 3 t^2 - 2 t^3 along each axis. */
static void cubic(ReferenceNoise noise, const double p[3], Sum *sum)
{
    uint32_t cell[3];
    double d[3];
    for (int axis = 0; axis < 3; axis++) {
        cell[axis] = wrap(floor(p[axis]));
        d[axis] = fraction(p[axis]);
    }
    for (int index = 0; index < 8; index++) {
        uint32_t c[3];
        double e[3], share[3], rise[3];
        for (int axis = 0; axis < 3; axis++) {
            int upper = index >> axis & 1;
            double s = d[axis] * d[axis] * (3 - 2 * d[axis]), ds = 6 * d[axis] * (1 - d[axis]);
            c[axis] = (cell[axis] + (uint32_t)upper) % PERIOD;
            e[axis] = d[axis] - upper;
            share[axis] = upper ? s : 1 - s;
            rise[axis] = upper ? ds : -ds;
        }
        const Weight weight = {share[0] * share[1] * share[2],
                               {rise[0] * share[1] * share[2], share[0] * rise[1] * share[2],
                                share[0] * share[1] * rise[2]}};
        Corner corner = corner_of(noise, c, sum->outputs);
        add_corner(&corner, e, &weight, sum);
    }
}

/* Finds the corners of the simplex around x, in order: each step follows the axis of the next
 * smaller fraction. */
static void simplex_steps(const double x[3], int steps[4][3])
{
    int rank[3];
    for (int i = 0; i < 3; i++) {
        rank[i] = 0;
        for (int k = 0; k < 3; k++)
            rank[i] += k != i && (x[k] > x[i] || (x[k] == x[i] && k < i));
    }
    for (int corner = 0; corner < 4; corner++)
        for (int i = 0; i < 3; i++)
            steps[corner][i] = rank[i] < corner;
}

/* Gradient noise on the simplex lattice (Gustavson 2005) with the kernel (1/2 - r^2)^4, which is
 * 0 at a simplex' border, so the noise is continuous; the usual 0.6 instead of 1/2 is not. */
static void simplex(ReferenceNoise noise, const double far[3], Sum *sum)
{
    const double p[3] = {fmod(far[0], 3. * PERIOD), fmod(far[1], 3. * PERIOD),
                         fmod(far[2], 3. * PERIOD)};
    double skew = (p[0] + p[1] + p[2]) / 3, base[3], x0[3], unskew;
    int steps[4][3];
    for (int i = 0; i < 3; i++)
        base[i] = floor(p[i] + skew);
    unskew = (base[0] + base[1] + base[2]) / 6;
    for (int i = 0; i < 3; i++)
        x0[i] = p[i] - (base[i] - unskew);
    simplex_steps(x0, steps);
    for (int index = 0; index < 4; index++) {
        uint32_t c[3];
        double e[3], r = 0;
        for (int i = 0; i < 3; i++) {
            c[i] = wrap(base[i] + steps[index][i]);
            e[i] = x0[i] - steps[index][i] + index / 6.;
            r += e[i] * e[i];
        }
        double t = fmax(.5 - r, 0);
        Weight weight = {.value = SIMPLEX_SCALE * t * t * t * t};
        for (int i = 0; i < 3; i++)
            weight.slope[i] = -8 * SIMPLEX_SCALE * t * t * t * e[i];
        Corner corner = corner_of(noise, c, sum->outputs);
        for (int output = 0; output < sum->outputs; output++)
            corner.number[output][0] = 0;
        add_corner(&corner, e, &weight, sum);
    }
}

static Sum lattice(ReferenceNoise noise, const double p[3], int outputs)
{
    Sum sum = {.outputs = outputs};
    if (noise == REFERENCE_SIMPLEX || noise == REFERENCE_SIMPLEX_FLOAT)
        simplex(noise, p, &sum);
    else
        cubic(noise, p, &sum);
    return sum;
}

void reference_lattice_slope(ReferenceNoise noise, const double p[3], double result[3],
                             double slope[3][3])
{
    const Sum sum = lattice(noise, p, OUTPUTS);
    memcpy(result, sum.value, sizeof sum.value);
    memcpy(slope, sum.slope, sizeof sum.slope);
}

void reference_lattice3(ReferenceNoise noise, const double p[3], double result[3])
{
    const Sum sum = lattice(noise, p, OUTPUTS);
    memcpy(result, sum.value, sizeof sum.value);
}

double reference_lattice(ReferenceNoise noise, const double p[3], double slope[3])
{
    const Sum sum = lattice(noise, p, 1);
    if (slope)
        memcpy(slope, sum.slope[0], sizeof sum.slope[0]);
    return sum.value[0];
}
