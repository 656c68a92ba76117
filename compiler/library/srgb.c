/* The sRGB transfer function, IEC 61966-2-1, with its published constants: linear near black, a
 * power of 2.4 above. */
#include "compiler/library/srgb.h"
#include <math.h>

double srgb_decode(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : pow((encoded + 0.055) / 1.055, 2.4);
}
