/* Synthesizes the height map of the Carpenter map. */
#ifndef MATC_CARPENTER_H
#define MATC_CARPENTER_H
#include <stdint.h>

/* Parameters of the map: the height at the corners, the range of the first offsets, and how fast
 * the range falls per level. */
typedef struct {
    double color, noise, roughness;
    int64_t seed;
    int width, height; /* size in texels, each from 1 to 2048 */
} CarpenterRelief;

/* Fills width x height texels, row 0 at the bottom. All are finite. */
void carpenter_bake(const CarpenterRelief *carpenter, float *texels);
#endif
