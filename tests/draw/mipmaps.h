/* Pictures of a few texels whose mipmaps are made by hand, without any code of the compiler. */
#ifndef MATC_VALUE_MIPMAPS_H
#define MATC_VALUE_MIPMAPS_H
#include <stdbool.h>

enum { MIPMAPS_SIDE = 8, MIPMAPS_LEVELS = 4, MIPMAPS_COMPONENTS = 3 };
typedef enum { REPEAT, MIRROR, CLAMP, BORDER, ADDRESS_COUNT } Address;

/* Mipmaps of texels: level 0 is the picture, texel (column, row) of a level the mean of four of the
 * one below; row 0 is at v = 0. */
typedef struct {
    int side;
    Address address;
    double texel[MIPMAPS_LEVELS][MIPMAPS_SIDE][MIPMAPS_SIDE][MIPMAPS_COMPONENTS];
    char path[64];
} Mipmaps;

/* Writes side.png into the folder: any bytes, far from each other. */
bool mipmaps_write(Mipmaps *mipmaps, int side, const char *folder);
/* Mixed of the four texels around a place of a level, of which whole numbers are the texels' own;
 * of a border there is nothing. */
double mipmaps_bilinear(const Mipmaps *mipmaps, int level, double x, double y, int component);

#endif
