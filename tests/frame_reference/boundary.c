/* Marching squares between four pixels: lit areas, and the length of the shadow boundary through
 * them. */
#include "tests/frame_reference/boundary.h"
#include <math.h>

static const double pi = 3.14159265358979323846;

/* True if the square of pixels to the right and above lies on one surface, and is lit except for
 * shadows. */
static bool is_whole(const Boundary *b, int first)
{
    for (int i = 0; i < 4; i++) {
        const int pixel = first + i / 2 * b->edge + i % 2;
        const double x = b->places[pixel][0] - b->places[first][0],
                     y = b->places[pixel][1] - b->places[first][1];
        if (!(b->light[pixel] > 0) || !(hypot(x, y) <= b->widest))
            return false;
    }
    return true;
}

/* Half the cross product of the diagonals. */
static double area_of(const double (*low)[2], const double (*high)[2])
{
    const double rising[2] = {high[1][0] - low[0][0], high[1][1] - low[0][1]};
    const double falling[2] = {high[0][0] - low[1][0], high[0][1] - low[1][1]};
    return fabs(rising[0] * falling[1] - rising[1] * falling[0]) / 2;
}

/* Length of the boundary between midpoints of edges whose ends differ: one segment, or two if
 * opposite corners are equal. */
static double crossing_of(const Boundary *b, int first)
{
    const int corners[5] = {first, first + 1, first + b->edge + 1, first + b->edge, first};
    double middles[4][2], length = 0;
    int count = 0;
    for (int i = 0; i < 4; i++)
        if ((b->truth[corners[i]] < .5f) != (b->truth[corners[i + 1]] < .5f)) {
            for (int component = 0; component < 2; component++)
                middles[count][component] =
                    (b->places[corners[i]][component] + b->places[corners[i + 1]][component]) / 2;
            count++;
        }
    for (int i = 0; i < count; i += 2)
        length += hypot(middles[i][0] - middles[i + 1][0], middles[i][1] - middles[i + 1][1]);
    return length;
}

/* Segments run along pixels and their diagonals: a line at the angle a to the pixels, from 0 to
 * 45 degrees, is measured too long by the factor cos a + (sqrt 2 - 1) sin a, whose mean over all
 * angles is 8 (sqrt 2 - 1) / pi. */
double boundary_length(const Boundary *b)
{
    double sum = 0;
    for (int y = 0; y + 1 < b->edge; y++)
        for (int x = 0; x + 1 < b->edge; x++)
            if (is_whole(b, y * b->edge + x))
                sum += crossing_of(b, y * b->edge + x);
    return sum * pi / (8 * (sqrt(2) - 1));
}

double boundary_area(const Boundary *b, const float *shares)
{
    double sum = 0;
    for (int y = 0; y + 1 < b->edge; y++)
        for (int x = 0; x + 1 < b->edge; x++) {
            const int pixel = y * b->edge + x;
            if ((shares[pixel] < .5f) != (b->truth[pixel] < .5f) && is_whole(b, pixel))
                sum += area_of(b->places + pixel, b->places + pixel + b->edge);
        }
    return sum;
}
