/* Random scenes, for tests. */
#ifndef MATC_FRAME_RANDOM_H
#define MATC_FRAME_RANDOM_H
#include <stdbool.h>
#include <stdint.h>

/* A document, from malloc, the same for the same seed: so many objects around the eye, on all sides
 * of it, some of them mirrored or flat as needles, of materials that share programs. */
char *frame_random_text(uint64_t seed, int count, bool orthographic);
#endif
