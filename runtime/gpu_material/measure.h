/* Statistics of a whole picture for tone mapping: maxima, sums, logarithms; a parallel reduction
 * on the GPU, in steps of 16 by 16. */
#ifndef MATC_RENDER_MEASURE_H
#define MATC_RENDER_MEASURE_H
#include "runtime/gpu_material/screen_pass.h"

enum {
    MEASURE_BLOCK = 16,
    MEASURE_STEPS = 4 /* max steps: 16384 pixels are reduced to one */,
    MEASURE_TEXELS = 3
};

#define MEASURE_GREATEST 1e18f /* max measured value, as in tone.glsl */

typedef struct {
    int count; /* number of steps */
    ScreenPass passes[MEASURE_STEPS];
    /* results of the steps; the last holds the three texels that tone.glsl reads */
    Framebuffer targets[MEASURE_STEPS];
} Measure;

/* Makes the steps. `texts` precede measure.glsl: tone.glsl and its definitions; NULL ends the
 * list. */
bool measure_make(Store *store, const int size[2], bool compute, const char *const *texts,
                  Measure *made);
/* Measures a texture of that size. The caller binds other inputs of the first step. */
void measure_run(Measure *measure, GLuint picture, const Screen *screen);
/* Restricts the statistics to a rectangle of the picture: the first pixel, and one past the
 * last. */
void measure_set_part(Measure *measure, const int part[2][2]);
/* Reads the three texels of the result. */
bool measure_read(const Measure *measure, float texels[MEASURE_TEXELS][4]);
/* Merges the statistics of two parts of a picture into `texels`. */
void measure_merge(float texels[MEASURE_TEXELS][4], const float other[MEASURE_TEXELS][4]);
/* Returns the texture of the result. */
GLuint measure_result(const Measure *measure);
/* Frees the steps and leaves *measure empty; safe on an empty one. */
void measure_delete(GlContext *gl, Measure *measure);
#endif
