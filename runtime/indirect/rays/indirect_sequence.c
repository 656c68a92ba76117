/* Samples of the unit square, and their shifts from pixel to pixel. */
#include "runtime/indirect/rays/indirect_sequence.h"
#include "runtime/indirect/rays/blue_noise.h"
#include <math.h>
#include <stdint.h>

/* Radical inverse: the digits of i mirrored at the point. 6 in base 2, 110, becomes 0.011, 3/8. */
static double mirrored(unsigned i, unsigned base)
{
    double sum = 0, share = 1. / base;
    for (; i; i /= base, share /= base)
        sum += share * (i % base);
    return sum;
}

/* Second dimension of Sobol's sequence: XOR of the rows of Pascal's triangle modulo 2, 1, 11,
 * 101, 1111, ..., for the set bits of i, read as binary fractions. 3, bits 0 and 1, gives 0.10 ^
 * 0.11 = 1/4. */
static double sobol(unsigned i)
{
    uint32_t sum = 0;
    for (uint32_t row = 1u << 31; i; i >>= 1, row ^= row >> 1)
        sum ^= i & 1 ? row : 0;
    return sum * 0x1p-32;
}

/* SplitMix (Steele, Lea and Flood 2014). */
static double random_next(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return (double)((z ^ z >> 31) >> 11) * 0x1p-53;
}

void indirect_sequence_samples(Keyword sequence, int count, double (*samples)[2])
{
    uint64_t state = 0;
    for (int i = 0; i < count; i++) {
        const unsigned number = (unsigned)i;
        samples[i][0] = sequence == KEYWORD_Sequence_random       ? random_next(&state)
                        : sequence == KEYWORD_Sequence_hammersley ? (double)i / count
                                                                  : mirrored(number, 2);
        samples[i][1] = sequence == KEYWORD_Sequence_random   ? random_next(&state)
                        : sequence == KEYWORD_Sequence_sobol  ? sobol(number)
                        : sequence == KEYWORD_Sequence_halton ? mirrored(number, 3)
                                                              : mirrored(number, 2);
    }
}

double indirect_sequence_third(Keyword sequence, int i)
{
    return mirrored((unsigned)i, sequence == KEYWORD_Sequence_halton ? 5 : 3);
}

int indirect_sequence_edge(const IndirectSequence *of)
{
    return of->rotation == KEYWORD_Rotation_blue    ? BLUE_NOISE_EDGE
           : of->rotation != KEYWORD_Rotation_tile  ? 0
           : of->sequence == KEYWORD_Sequence_sobol ? INDIRECT_SEQUENCE_TILE
                                                    : INDIRECT_SEQUENCE_TILE / 2;
}

/* Interleaves the bits of x and y (Morton order): aligned blocks of 2 x 2, 4 x 4, ... pixels
 * have consecutive numbers. */
static unsigned woven(unsigned x, unsigned y)
{
    unsigned sum = 0;
    for (unsigned bit = 0; bit < 8; bit++)
        sum |= (x >> bit & 1) << 2 * bit | (y >> bit & 1) << (2 * bit + 1);
    return sum;
}

static unsigned power_above(int count)
{
    unsigned power = 1;
    while (power < (unsigned)count)
        power *= 2;
    return power;
}

int indirect_sequence_block(const IndirectSequence *of) { return (int)power_above(of->count); }

static void tile_of_sobol(const IndirectSequence *of, unsigned x, unsigned y, double shift[3])
{
    const unsigned k = woven(x, y), number = k * power_above(of->count);
    shift[0] = mirrored(number, 2);
    shift[1] = sobol(number);
    shift[2] = fmod(k * 0.6180339887498949, 1);
}

/* Numbers pixels by Bayer's matrix, in which neighbors have very different numbers. */
static void tile_of_others(const IndirectSequence *of, unsigned x, unsigned y, double shift[3])
{
    const unsigned mixed = x ^ y;
    const unsigned k = (mixed & 1) << 3 | (y & 1) << 2 | (mixed & 2) | y >> 1;
    shift[0] = k / (16. * of->count);
    shift[1] = mirrored(k, 2);
    shift[2] = (k * 7 & 15) / 16.;
}

void indirect_sequence_shift(const IndirectSequence *of, int x, int y, double shift[3])
{
    static const int beside[3][2] = {
        {0, 0}, {21, 43}, {43, 21}}; /* offsets at which the mask is uncorrelated with itself */
    const int edge = indirect_sequence_edge(of);
    for (int i = 0; i < 3; i++)
        shift[i] = 0;
    for (int i = 0; i < 3 && of->rotation == KEYWORD_Rotation_blue; i++)
        shift[i] = (blue_noise_rank((x + beside[i][0]) % edge, (y + beside[i][1]) % edge) + .5) /
                   (edge * edge);
    if (of->rotation == KEYWORD_Rotation_tile)
        (of->sequence == KEYWORD_Sequence_sobol ? tile_of_sobol : tile_of_others)(
            of, (unsigned)(x % edge), (unsigned)(y % edge), shift);
}
