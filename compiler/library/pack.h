/* Half floats as codes: references of the packing functions of layouts. */
#ifndef MATC_LIB_PACK_H
#define MATC_LIB_PACK_H
#include <stdint.h>

enum {
    HALF_CODES = 61440, /* finite half floats, neither zero nor subnormal */
    RADIX_X = 247,
    RADIX_Y = 248 /* steps of the two numbers in a half float */
};
_Static_assert(RADIX_X *RADIX_Y <= HALF_CODES, "every pair has a code");

/* Code 0 is 2^-14, code 30719 is 65504; the negatives follow. */
double pack_half_from_code(int code);
/* The half float nearest to v, ties to even, clamped to 65504: its bits, and the value of such
 * bits. */
uint16_t pack_half_bits(double v);
double pack_half_value(uint16_t bits);
#endif
