/* Packing functions of layouts: pairs in a half float, and words of bits. */
#include "compiler/library/pack.h"
#include "compiler/library/reference.h"

#define HALF_MAX         65504. /* the largest half float */
#define HALF_MIN         ldexp(1, -14)
#define HALF_SUBNORMAL   ldexp(1, -24)
#define FLOAT_MAX        3.4028234e38
#define PAIR_SCALE       127.5 /* the largest code is 127 */
#define LOGARITHM_MIN    ldexp(1, -4)
#define LOGARITHM_SPAN   log2(HALF_MAX / LOGARITHM_MIN)
#define EXPONENT_BIAS    15
#define SHARED_BITS      9    /* max bits of a component */
#define EXPONENTS_OF_ONE 1024 /* half floats per exponent */

double pack_half_from_code(int code)
{
    int half = HALF_CODES / 2, c = code % half;
    double size = ldexp(EXPONENTS_OF_ONE + c % EXPONENTS_OF_ONE, c / EXPONENTS_OF_ONE - 24);
    return code < half ? size : -size;
}

/* nearbyint rounds ties to even. */
uint16_t pack_half_bits(double v)
{
    double size = fmin(fabs(v), HALF_MAX);
    int exponent = size < HALF_MIN ? -14 : ilogb(size);
    double steps = nearbyint(size / ldexp(1, exponent - 10));
    return (uint16_t)((v < 0 ? 0x8000 : 0) + (exponent + 14) * EXPONENTS_OF_ONE + (int)steps);
}

double pack_half_value(uint16_t bits)
{
    int exponent = bits >> 10 & 31, mantissa = bits & 1023;
    double size =
        exponent ? ldexp(EXPONENTS_OF_ONE + mantissa, exponent - 25) : mantissa * HALF_SUBNORMAL;
    return bits & 0x8000 ? -size : size;
}

REFERENCE(packPair)
{
    (void)context;
    double x = floor(PAIR_SCALE * clamp(args[0], 0, 1)),
           y = floor(PAIR_SCALE * clamp(args[1], 0, 1));
    result[0] = ldexp(1 + fraction(x / 8) + y / 1024, (int)floor(x / 8));
}

REFERENCE(unpackPair)
{
    (void)context;
    int exponent;
    double m = 8 * (2 * frexp(clamp(args[0], 1, HALF_MAX), &exponent) - 1);
    result[0] = (floor(m) + 8 * (exponent - 1)) / PAIR_SCALE;
    result[1] = 128 * fraction(m) / PAIR_SCALE;
}

static int nearest(double v, int levels)
{
    return whole_between(clamp(v, 0, 1) * (levels - 1) + .5, 0, levels - 1);
}

static int bits_of(double v) { return whole_between(v, 1, REFERENCE_BITS); }

REFERENCE(packRadix)
{
    (void)context;
    result[0] =
        pack_half_from_code(nearest(args[0], RADIX_X) + RADIX_X * nearest(args[1], RADIX_Y));
}

REFERENCE(plainHalf)
{
    (void)context;
    result[0] = fabs(args[0]) < HALF_MIN ? 0 : clamp(args[0], -HALF_MAX, HALF_MAX);
}

REFERENCE(unormBits)
{
    (void)context;
    result[0] = nearest(args[0], 1 << bits_of(args[1]));
}

REFERENCE(rootBits)
{
    (void)context;
    result[0] = nearest(sqrt(clamp(args[0], 0, 1)), 1 << bits_of(args[1]));
}

REFERENCE(logarithmBits)
{
    (void)context;
    int steps = (1 << bits_of(args[1])) - 2;
    double place = log2(fmax(args[0], LOGARITHM_MIN) / LOGARITHM_MIN) * steps / LOGARITHM_SPAN;
    result[0] = args[0] < LOGARITHM_MIN / 2 ? 0 : fmin(floor(place + .5), steps) + 1;
}

REFERENCE(halfBits)
{
    (void)context;
    result[0] = pack_half_bits(args[0]);
}

/* Returns the bit pattern of the float nearest to the argument. */
REFERENCE(floatBits)
{
    (void)context;
    union {
        float number;
        uint32_t word;
    } pattern = {.number = (float)clamp(args[0], -FLOAT_MAX, FLOAT_MAX)};
    result[0] = pattern.word;
}

REFERENCE(sharedExponentBits)
{
    (void)context;
    int bits = whole_between(args[3], 1, SHARED_BITS);
    double most = ldexp(ldexp(1, bits) - 1, 16 - bits), greatest = 0, code = 0;
    for (int i = 0; i < 3; i++)
        greatest = fmax(greatest, clamp(args[i], 0, most));
    int exponent = greatest > 0 ? (int)fmax(ilogb(greatest) + 1 + EXPONENT_BIAS, 0) : 0;
    if (floor(ldexp(greatest, bits + EXPONENT_BIAS - exponent) + .5) >= ldexp(1, bits))
        exponent++;
    for (int i = 0; i < 3; i++)
        code += ldexp(floor(ldexp(clamp(args[i], 0, most), bits + EXPONENT_BIAS - exponent) + .5),
                      i * bits);
    result[0] = code + ldexp(exponent, 3 * bits);
}
