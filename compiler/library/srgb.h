/* The sRGB transfer function, IEC 61966-2-1. */
#ifndef MATC_SRGB_H
#define MATC_SRGB_H

/* Decodes to linear light: 0 is 0, 1 is 1, 128 / 255 is 0.21586. */
double srgb_decode(double encoded);
#endif
