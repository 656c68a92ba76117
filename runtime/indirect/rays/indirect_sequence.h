/* Samples of the unit square, which become directions of rays, and how each pixel's differ from
 * them. Private to indirect_pass.c and tests.
 *
 * Rotation `tile` shifts the n samples of each pixel so that those of a whole tile are as even as
 * those of one pixel; tiles are alike, so that any window of a tile's size has all of them. Of
 * Sobol's sequence, 8 x 8 pixels: it is a net, which means that of the 2^m samples from a multiple
 * of 2^m on, each of 2^m equal boxes has one, whichever powers of two its sides are. So pixel k, by
 * the bits of x and y in turn, takes the samples from k n on, n rounded up to a power of two: each
 * 2 x 2 pixels have a net of 4 n, each 4 x 4 one of 16 n, the tile one of 64 n. Sample k n + i is
 * sample i with those bits turned that sample k n has, so that a pixel's shift is one pair of
 * numbers. Of several sets of samples the j-th is turned by the bits of sample j n as well: so it
 * takes what pixel k with j's bits turned has in the first one. So each set of a tile is a net, and
 * all sets of a pixel together are one, too.
 * The other sequences have tiles of 4 x 4 pixels: pixel k, by Bayer's matrix, adds (k / 16 n,
 * mirrored bits of k / 16), modulo 1, which of Hammersley's makes one set of 16 n.
 *
 * Rotation `blue` adds three values of blue noise, modulo 1.
 *
 *     4 samples of Sobol's: (0, 0), (1/2, 1/2), (1/4, 3/4), (3/4, 1/4); pixel (1, 0) is k = 1 and
 *     has samples 4 to 7, shifted by sample 4, (1/8, 5/8), by exclusive or:
 *     (1/8, 5/8), (5/8, 1/8), (3/8, 3/8), (7/8, 7/8) */
#ifndef MATC_RENDER_INDIRECT_SEQUENCE_H
#define MATC_RENDER_INDIRECT_SEQUENCE_H
#include "grammar/scene_tables.h"

enum { INDIRECT_SEQUENCE_TILE = 8 };

typedef struct {
    Word sequence, rotation;
    int count; /* of a pixel's samples */
} IndirectSequence;

/* `count` samples of the unit square. */
void indirect_sequence_samples(Word sequence, int count, double (*samples)[2]);
/* A third lane of the i-th, for samples of a cube: in base 5 behind Halton's, else in base 3. */
double indirect_sequence_third(Word sequence, int i);
/* Shifts repeat after so many pixels; 0: they are not in a table. */
int indirect_sequence_edge(const IndirectSequence *of);
/* So many of Sobol's samples a pixel has to itself: the count, rounded up to a power of two. */
int indirect_sequence_block(const IndirectSequence *of);
/* Shift of a pixel's samples, 0 to 1, and a third random number. For Sobol's sequence with rotation
 * tile the shift is by exclusive or of the first 16 bits, otherwise by addition modulo 1. */
void indirect_sequence_shift(const IndirectSequence *of, int x, int y, double shift[3]);
#endif
