/* The error measure of matbench shadows: boundaries of discs by closed forms, seen
 * perpendicularly and obliquely; pixels that are not measured. */
#include "tests/test.h"
#include "tests/frame_reference/boundary.h"
#include <math.h>
#include <stdlib.h>

enum { EDGE = 400, PIXELS = EDGE * EDGE };

static const double pi = 3.14159265358979323846;

typedef struct {
    double places[PIXELS][2];
    float light[PIXELS], truth[PIXELS], shares[PIXELS];
} Picture;

/* Discs around the middle of a plane with pixels at x = across[0] i + across[1] j, y = up[0] i +
 * up[1] j; on the right another surface. */
static Picture *picture_of(const double across[2], const double up[2], double true_radius,
                           double radius)
{
    Picture *p = malloc(sizeof *p);
    assert_non_null(p);
    for (int i = 0; i < PIXELS; i++) {
        const double column = i % EDGE - EDGE / 2 + .3, row = i / EDGE - EDGE / 2 + .1;
        const double x = across[0] * column + across[1] * row, y = up[0] * column + up[1] * row;
        p->places[i][0] = x;
        p->places[i][1] = y;
        p->light[i] = 1;
        p->truth[i] = hypot(x, y) >= true_radius;
        p->shares[i] = hypot(x, y) >= radius ? .7f : .2f;
    }
    return p;
}

static void compare(const double across[2], const double up[2], double true_radius, double radius)
{
    Picture *p = picture_of(across, up, true_radius, radius);
    const Boundary boundary = {EDGE, (const double(*)[2])p->places, p->light, p->truth, 4};
    const double length = boundary_length(&boundary), area = boundary_area(&boundary, p->shares);
    const double ring = pi * fabs(radius * radius - true_radius * true_radius);
    assert_true(fabs(length / (2 * pi * true_radius) - 1) < .03);
    assert_true(fabs(area - ring) <= .02 * ring);
    assert_true(boundary_area(&boundary, p->truth) == 0); /* nothing is wrong of the truth */
    free(p);
}

static void discs(void **state)
{
    (void)state;
    compare((double[]){.25, 0}, (double[]){0, .25}, 30, 30.5);
    compare((double[]){.25, 0}, (double[]){0, .25}, 30, 28);
    compare((double[]){.2, .1}, (double[]){-.05, .3}, 20, 20.4);
    compare((double[]){.3, .1}, (double[]){.2, -.2}, 20, 19);
}

/* Pixels that face away, are empty, or lie on two surfaces add neither length nor area: half of
 * the plane remains. */
static void halves(void **state)
{
    (void)state;
    Picture *p = picture_of((double[]){.25, 0}, (double[]){0, .25}, 30, 31);
    const Boundary boundary = {EDGE, (const double(*)[2])p->places, p->light, p->truth, 4};
    const double length = boundary_length(&boundary), area = boundary_area(&boundary, p->shares);
    for (int i = 0; i < PIXELS; i++)
        if (i % EDGE >= EDGE / 2)
            p->light[i] = i % 3 ? 0 : (float)NAN;
    assert_true(fabs(boundary_length(&boundary) / length - .5) < .01);
    assert_true(fabs(boundary_area(&boundary, p->shares) / area - .5) < .01);
    for (int i = 0; i < PIXELS; i++) {
        p->light[i] = 1;
        p->places[i][0] += i % EDGE >= EDGE / 2 ? 100 * (i % EDGE) : 0;
    }
    assert_true(fabs(boundary_length(&boundary) / length - .5) < .01);
    assert_true(fabs(boundary_area(&boundary, p->shares) / area - .5) < .01);
    free(p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(discs), cmocka_unit_test(halves)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
