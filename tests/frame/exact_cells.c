#include "tests/frame/exact_cells.h"
#include <math.h>
#include <string.h>

float exact_cell_number(const uint32_t *head, int word)
{
    float number;
    memcpy(&number, head + word, sizeof number);
    return number;
}

/* Coordinates along the light's axes. */
static void place_of(const uint32_t *head, const double at[3], double place[3])
{
    const bool placed = exact_cell_number(head, EXACT_LISTS_PLACED) > 0;
    for (int row = 0; row < 3; row++) {
        place[row] = exact_cell_number(head, EXACT_LISTS_ROWS + 4 * row + 3);
        for (int k = 0; k < 3; k++)
            place[row] += exact_cell_number(head, EXACT_LISTS_ROWS + 4 * row + k) *
                          (at[k] - (placed ? exact_cell_number(head, EXACT_LISTS_FROM + k) : 0));
    }
    if (!placed)
        place[2] = 1;
}

long exact_cell_of(const uint32_t *head, const double at[3])
{
    const long size = head[EXACT_LISTS_SIZE];
    double place[3], turned[3];
    long face = 0;
    place_of(head, at, place);
    memcpy(turned, place, sizeof turned);
    if (head[EXACT_LISTS_VIEWS] == 6) {
        int axis = 0;
        for (int k = 1; k < 3; k++)
            axis = fabs(place[k]) > fabs(place[axis]) ? k : axis;
        for (int k = 0; k < 3; k++)
            turned[k] = place[(axis + 1 + k) % 3];
        face = 2 * axis + (turned[2] < 0);
        turned[2] = fabs(turned[2]);
    }
    const double x = turned[0] / turned[2], y = turned[1] / turned[2];
    if (turned[2] <= 0 || fabs(x) >= 1 || fabs(y) >= 1)
        return -1;
    return (face * size + (long)((y * .5 + .5) * (double)size)) * size +
           (long)((x * .5 + .5) * (double)size);
}

/* Clips to component <= to * z; with sign -1: component >= -to * z. */
static void clip(ExactPolygon *polygon, int component, double sign, double to)
{
    ExactPolygon kept = {.count = 0};
    for (int i = 0; i < polygon->count; i++) {
        const double *a = polygon->at[i], *b = polygon->at[(i + 1) % polygon->count];
        const double in = to * a[2] - sign * a[component], next = to * b[2] - sign * b[component];
        if (in >= 0)
            memcpy(kept.at[kept.count++], a, sizeof kept.at[0]);
        if ((in < 0) != (next < 0)) {
            for (int k = 0; k < 3; k++)
                kept.at[kept.count][k] = a[k] + in / (in - next) * (b[k] - a[k]);
            kept.count++;
        }
    }
    *polygon = kept;
}

bool exact_cell_has(const uint32_t *head, const ExactPolygon *of, const int cell[2], double wider)
{
    const double size = head[EXACT_LISTS_SIZE];
    ExactPolygon polygon = *of;
    for (int component = 0; component < 2; component++) {
        clip(&polygon, component, 1, 2 * (cell[component] + 1 + wider) / size - 1);
        clip(&polygon, component, -1, -(2 * (cell[component] - wider) / size - 1));
    }
    return polygon.count > 0;
}

ExactPolygon exact_cell_polygon(const uint32_t *head, ExactCorners *corners, int face)
{
    ExactPolygon polygon = {.count = 3};
    double place[3];
    for (int corner = 0; corner < 3; corner++) {
        const float *c = (*corners)[corner];
        place_of(head, (double[]){c[0], c[1], c[2]}, place);
        for (int k = 0; k < 3; k++)
            polygon.at[corner][k] =
                head[EXACT_LISTS_VIEWS] == 6 ? place[(face / 2 + 1 + k) % 3] : place[k];
        if (face % 2)
            polygon.at[corner][2] = -polygon.at[corner][2];
    }
    return polygon;
}
