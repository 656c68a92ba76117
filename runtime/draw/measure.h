/* Statistics of a whole picture for tone mapping: maxima, sums, logarithms; reduced by the GPU, in
 * steps of 16 by 16. */
#ifndef MATC_RENDER_MEASURE_H
#define MATC_RENDER_MEASURE_H
#include "runtime/draw/screen_pass.h"

enum {
    MEASURE_BLOCK = 16,
    MEASURE_STEPS = 4 /* to one from a side of 16384 */,
    MEASURE_TEXELS = 3
};

#define MEASURE_GREATEST 1e18f /* as tone.glsl has it */

typedef struct {
    int count; /* of steps */
    ScreenPass passes[MEASURE_STEPS];
    Framebuffer targets[MEASURE_STEPS]; /* the last has the three texels that tone.glsl tells of */
} Measure;

/* `texts` come before measure.glsl: tone.glsl and what it is told; NULL ends the list. */
bool measure_make(Store *store, const int size[2], bool compute, const char *const *texts,
                  Measure *made);
/* Measures a texture of that size. Other inputs of the first step are bound by the caller. */
void measure_run(Measure *measure, GLuint picture, const Screen *screen);
/* Restricts the statistics to the pixels from the first of `part` up to the other one; both lie in
 * the picture. */
void measure_set_part(Measure *measure, const int part[2][2]);
/* The three texels of the result. */
bool measure_read(const Measure *measure, float texels[MEASURE_TEXELS][4]);
/* Merges the statistics of two parts of a picture into `texels`. */
void measure_merge(float texels[MEASURE_TEXELS][4], const float other[MEASURE_TEXELS][4]);
/* The texture of the result. */
GLuint measure_result(const Measure *measure);
/* Safe on an empty one, which it leaves behind. */
void measure_delete(GlContext *gl, Measure *measure);
#endif
