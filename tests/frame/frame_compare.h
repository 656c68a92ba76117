/* Compares pictures with the reference: the distribution of the pixels' errors. */
#ifndef MATC_FRAME_COMPARE_H
#define MATC_FRAME_COMPARE_H
#include "tests/frame_reference/reference_light.h"
#include "tests/test.h"
#include <math.h>
#include <stdlib.h>

static inline int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Errors at evenly spread pixels that show objects, except in a band along edges. */
typedef struct {
    double differences[1 << 16];
    int count, lit;
} Spread;

static inline void add_sample(Spread *spread, const Sample *sample, const float *rgba)
{
    double greatest = 0, bright = 0;
    if (sample->edge || sample->nothing)
        return;
    for (int component = 0; component < 3; component++) {
        greatest = fmax(greatest, isnan(rgba[component])
                                      ? INFINITY
                                      : fabs(rgba[component] - sample->light[component]));
        bright = fmax(bright, sample->light[component]);
    }
    spread->differences[spread->count++] = greatest;
    spread->lit += bright > 1e-3;
}

/* True if half of the errors are within `median`, and 99.9 % within 1e-4. */
static inline bool is_close(const char *name, double median, Spread *spread)
{
    qsort(spread->differences, (size_t)spread->count, sizeof *spread->differences, ascending);
    const double middle = spread->differences[spread->count / 2];
    const double most = spread->differences[(int)(spread->count * .999)];
    print_message("%-14s %5d pixels, median %.2g, 99.9 %% within %.2g\n", name, spread->count,
                  middle, most);
    assert_true(spread->count > 900);
    assert_true(spread->lit > spread->count * 2 / 3); /* a black picture would prove nothing */
    return middle <= median && most <= 1e-4;
}

/* Compares a fifth of a picture's pixels. */
static inline void compare(const Scene *scene, const MatcOptions *options, const float *rgba,
                           Spread *spread)
{
    enum { STEP = 5 };
    Tracer tracer = reference_open(scene);
    spread->count = spread->lit = 0;
    for (int i = 0; i < scene->width * scene->height; i += STEP) {
        const Sample sample =
            reference_sample(&tracer, i % scene->width, i / scene->width, options);
        add_sample(spread, &sample, rgba + 4 * (size_t)i);
    }
    reference_close(&tracer);
}

#endif
