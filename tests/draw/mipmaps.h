/* Pictures of a few texels whose mipmaps are made by hand, without any code of the compiler. */
#ifndef MATC_VALUE_MIPMAPS_H
#define MATC_VALUE_MIPMAPS_H
#include <stdbool.h>

enum { MIPMAPS_SIDE = 8, MIPMAPS_LEVELS = 4, MIPMAPS_COMPONENTS = 3 };
typedef enum { REPEAT, MIRROR, CLAMP, BORDER, ADDRESS_COUNT } Address;

/* Mipmap levels of texels: level 0 is the picture, texel (column, row) of a level is the mean of
 * four texels of the finer level; row 0 is at v = 0. */
typedef struct {
    int side;
    Address address;
    double texel[MIPMAPS_LEVELS][MIPMAPS_SIDE][MIPMAPS_SIDE][MIPMAPS_COMPONENTS];
    char path[64];
} Mipmaps;

/* Writes side.png into the folder, with arbitrary bytes that vary much. */
bool mipmaps_write(Mipmaps *mipmaps, int side, const char *folder);
/* Bilinear interpolation of the four texels around a position in a level, at whose integer
 * coordinates the texels are; texels outside of a border are 0. */
double mipmaps_bilinear(const Mipmaps *mipmaps, int level, double x, double y, int component);

#endif
