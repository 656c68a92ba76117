/* A mask of blue noise: neighbours have values far apart, so that what a small window has of them
 * is spread evenly, and what is left of an error is fine grain. Private to indirect_sequence.c and
 * tests. */
#ifndef MATC_RENDER_BLUE_NOISE_H
#define MATC_RENDER_BLUE_NOISE_H

enum { BLUE_NOISE_EDGE = 64 };
#define BLUE_NOISE_DIGITS "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+-"

/* From 0 to 64 * 64 - 1, each once; x and y from 0 to 63. It goes on at the other side. */
int blue_noise_rank(int x, int y);
#endif
