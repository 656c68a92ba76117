/* A blue noise mask: neighbors have very different values, so that any small window covers the
 * range evenly, and the error that remains is high-frequency noise. Private to
 * indirect_sequence.c and tests. */
#ifndef MATC_RENDER_BLUE_NOISE_H
#define MATC_RENDER_BLUE_NOISE_H

enum { BLUE_NOISE_EDGE = 64 };
#define BLUE_NOISE_DIGITS "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+-"

/* Returns the rank of a pixel, a permutation of 0 to 64 * 64 - 1; x and y from 0 to 63. The mask
 * tiles seamlessly. */
int blue_noise_rank(int x, int y);
#endif
