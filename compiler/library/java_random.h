/* java.util.Random as its documentation defines it: a 48-bit linear congruential generator.
 * GroIMP's tables and height maps use it. */
#ifndef MATC_JAVA_RANDOM_H
#define MATC_JAVA_RANDOM_H
#include <stdint.h>

enum { JAVA_RANDOM_BITS = 48 };
#define JAVA_RANDOM_FACTOR 0x5DEECE66DULL
#define JAVA_RANDOM_MASK   ((1ULL << JAVA_RANDOM_BITS) - 1)

static inline uint64_t java_random(int64_t seed)
{
    return ((uint64_t)seed ^ JAVA_RANDOM_FACTOR) & JAVA_RANDOM_MASK;
}

/* Java's next(bits): the topmost bits of the next state. */
static inline uint32_t java_random_bits(uint64_t *state, int bits)
{
    *state = (*state * JAVA_RANDOM_FACTOR + 0xB) & JAVA_RANDOM_MASK;
    return (uint32_t)(*state >> (JAVA_RANDOM_BITS - bits));
}

/* 2 nextFloat() - 1: uniform in [-1, 1), 24 bits, exact in a float. */
static inline float java_random_signed(uint64_t *state)
{
    return 2 * ((float)java_random_bits(state, 24) / 16777216) - 1;
}
#endif
