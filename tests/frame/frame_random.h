/* Random scenes, for tests. */
#ifndef MATC_FRAME_RANDOM_H
#define MATC_FRAME_RANDOM_H
#include <stdbool.h>
#include <stdint.h>

/* A document, from malloc, reproducible by its seed: `count` objects on all sides of the eye,
 * some of them mirrored or thin as needles, with materials that share programs. */
char *frame_random_text(uint64_t seed, int count, bool orthographic);
#endif
