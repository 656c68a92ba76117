/* Samples of the unit square, which become ray directions, and their shift from pixel to pixel.
 * Private to indirect_pass.c and tests.
 *
 * Rotation `tile` shifts the n samples of each pixel so that all samples of a tile together are
 * as evenly distributed as those of one pixel; tiles repeat, so that any window of a tile's size
 * has the same samples. Tiles of Sobol's sequence are 8 x 8 pixels. The sequence is a net: of
 * the 2^m samples from a multiple of 2^m on, each of 2^m equal boxes holds exactly one, for any
 * power-of-two sides. Pixel k, by the interleaved bits of x and y, takes the samples from k n
 * on, n rounded up to a power of two: each 2 x 2 pixels have a net of 4 n, each 4 x 4 one of 16
 * n, the tile one of 64 n. Sample k n + i is sample i XOR sample k n, so that a pixel's shift is
 * one pair of numbers. Set j of several sets is XORed with sample j n as well, which gives pixel
 * k the first set's samples of pixel k XOR j. So each set of a tile is a net, and all sets of a
 * pixel together are one, too.
 * The other sequences have tiles of 4 x 4 pixels: pixel k, by Bayer's matrix, adds (k / 16 n,
 * mirrored bits of k / 16), modulo 1, which for Hammersley's sequence makes one set of 16 n.
 *
 * Rotation `blue` adds three values of blue noise, modulo 1.
 *
 *     4 samples of Sobol's: (0, 0), (1/2, 1/2), (1/4, 3/4), (3/4, 1/4); pixel (1, 0) is k = 1
 *         and has samples 4 to 7, which are samples 0 to 3 XOR sample 4, (1/8, 5/8):
 *     (1/8, 5/8), (5/8, 1/8), (3/8, 3/8), (7/8, 7/8) */
#ifndef MATC_RENDER_INDIRECT_SEQUENCE_H
#define MATC_RENDER_INDIRECT_SEQUENCE_H
#include "grammar/scene_tables.h"

enum { INDIRECT_SEQUENCE_TILE = 8 };

typedef struct {
    Keyword sequence, rotation;
    int count; /* samples per pixel */
} IndirectSequence;

/* Computes `count` samples of the unit square. */
void indirect_sequence_samples(Keyword sequence, int count, double (*samples)[2]);
/* Returns the third coordinate of sample i, for samples of a cube: radical inverse in base 5 for
 * Halton's sequence, else in base 3. */
double indirect_sequence_third(Keyword sequence, int i);
/* Returns the period of the shifts in pixels; 0: shifts are not in a table. */
int indirect_sequence_edge(const IndirectSequence *of);
/* Returns the number of Sobol's samples reserved for a pixel: the count, rounded up to a power
 * of two. */
int indirect_sequence_block(const IndirectSequence *of);
/* Returns the shift of a pixel's samples, 0 to 1, and a third random number. The shift of
 * Sobol's sequence with rotation tile is an exclusive or of the first 16 bits, that of others an
 * addition modulo 1. */
void indirect_sequence_shift(const IndirectSequence *of, int x, int y, double shift[3]);
#endif
