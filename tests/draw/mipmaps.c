#include "tests/draw/mipmaps.h"
#include "compiler/base/output.h"
#include "runtime/gl/png_write.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { NOWHERE = -1 };

/* An arbitrary byte that differs much from its neighbors. */
static uint8_t byte_at(int column, int row, int component)
{
    return (uint8_t)(61 * column * column + 87 * row + 149 * column * row + 83 * component + 17);
}

static void fill_levels(Mipmaps *m)
{
    for (int level = 0; m->side >> level; level++)
        for (int row = 0; row < m->side >> level; row++)
            for (int column = 0; column < m->side >> level; column++)
                for (int component = 0; component < MIPMAPS_COMPONENTS; component++) {
                    double(*below)[MIPMAPS_SIDE][MIPMAPS_COMPONENTS] =
                        m->texel[level ? level - 1 : 0];
                    int x = 2 * column, y = 2 * row;
                    m->texel[level][row][column][component] =
                        !level ? byte_at(column, row, component) / 255.
                               : (below[y][x][component] + below[y][x + 1][component] +
                                  below[y + 1][x][component] + below[y + 1][x + 1][component]) /
                                     4;
                }
}

bool mipmaps_write(Mipmaps *m, int side, const char *folder)
{
    uint8_t bytes[MIPMAPS_SIDE * MIPMAPS_SIDE * MIPMAPS_COMPONENTS];
    *m = (Mipmaps){.side = side};
    snprintf(m->path, sizeof m->path, "%s/%d.png", folder, side);
    for (int i = 0; i < side * side * MIPMAPS_COMPONENTS; i++)
        bytes[i] = byte_at(i / MIPMAPS_COMPONENTS % side, i / MIPMAPS_COMPONENTS / side,
                           i % MIPMAPS_COMPONENTS);
    fill_levels(m);
    size_t size;
    const char *why;
    uint8_t *file = png_write(&(PngPicture){side, side, MIPMAPS_COMPONENTS, bytes}, &size, &why);
    if (file)
        why = output_write(m->path, file, size);
    free(file);
    return !why;
}

/* The texel index of an integer coordinate under an address mode, by walking there from the
 * picture; NOWHERE outside of a border. */
static int wrapped(Address address, double place, int side)
{
    int texel = (int)floor(place);
    if (texel >= 0 && texel < side)
        return texel;
    if (address == REPEAT)
        return wrapped(address, texel < 0 ? texel + side : texel - side, side);
    if (address == MIRROR)
        return wrapped(address, texel < 0 ? -1 - texel : 2 * side - 1 - texel, side);
    return address == BORDER ? NOWHERE : texel < 0 ? 0 : side - 1;
}

double mipmaps_bilinear(const Mipmaps *m, int level, double x, double y, int component)
{
    int side = m->side >> level;
    double sum = 0;
    for (int i = 0; i < 4; i++) {
        double column = floor(x) + i % 2, row = floor(y) + i / 2;
        int k = wrapped(m->address, column, side), l = wrapped(m->address, row, side);
        if (k != NOWHERE && l != NOWHERE)
            sum += (1 - fabs(x - column)) * (1 - fabs(y - row)) * m->texel[level][l][k][component];
    }
    return sum;
}
