/* Half floats as codes: the references of what layouts pack. */
#ifndef MATC_LIB_PACK_H
#define MATC_LIB_PACK_H
#include <stdint.h>

enum {
    HALF_CODES = 61440, /* half floats that are finite, not zero and not subnormal */
    RADIX_X = 247,
    RADIX_Y = 248 /* steps of two numbers in one half float */
};
_Static_assert(RADIX_X *RADIX_Y <= HALF_CODES, "every pair has a code");

/* Code 0 is 2^-14, code 30719 is 65504; then their negatives. */
double pack_half_from_code(int code);
/* The half float nearest to v, ties to even, at most 65504 in size; its value. */
uint16_t pack_half_bits(double v);
double pack_half_value(uint16_t bits);
#endif
