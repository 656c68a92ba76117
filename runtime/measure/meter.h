/* A context to measure in: draws points and views, times draws, reads G-buffers back. For one thread. */
#ifndef MATC_MEASURE_METER_H
#define MATC_MEASURE_METER_H
#include "runtime/measure/field.h"
#include "runtime/gl/framebuffer.h"
#include "runtime/gl/mesh.h"
#include "runtime/measure/shader.h"

enum { SLOT_FLOATS = 4 * SLOT_COUNT, READ_TARGETS = (SLOT_FLOATS + 3) / 4 };

typedef struct {
    GlContext *gl;
    Framebuffer numbers;              /* RGBA32F, a pixel a point */
    Framebuffer packed[LAYOUT_COUNT]; /* the same in a layout's format; made when first asked for */
    Shader unpack[LAYOUT_COUNT];      /* reads it back */
    bool holds[LAYOUT_COUNT][SLOT_COUNT];
    bool refused[LAYOUT_COUNT]; /* the driver, or the GL layer, has no such target */
    Mesh screen;
    char error[4096];
} Meter;

/* NULL: see `error`. The context is current afterwards. */
Meter *meter_open(GlKind kind, char *error, size_t room);
void meter_close(Meter *meter);

/* The render targets of a layout, of any size. False: see meter->error. */
bool meter_make_targets(Meter *meter, Layout layout, int width, int height, Framebuffer *made);

/* Draws points by a program of pass value: four floats a point. */
bool meter_draw_points(Meter *meter, const Shader *shader, const Field *points, float (*rgba)[4]);

/* Draws points by a program of pass gbuffer, and reads the slots back by the layout's own GLSL. `unpack_text` is
 * MATC_UNPACK of that layout. Slots that the layout does not hold are NaN. */
bool meter_draw_packed(Meter *meter, const Shader *shader, Layout layout, const char *unpack_text, const Field *points,
                       SlotValues *values);

/* The mean of n x n draws by a program of pass value, each moved within its part of a pixel: four floats a pixel.
 * n = 1 is the picture itself. `target` is one of RGBA32F. */
bool meter_draw_mean(Meter *meter, const Shader *shader, const Field *field, const Framebuffer *target, int n,
                     float *rgba);

/* What is to be timed. */
typedef struct {
    const Shader *shader;
    const Field *field;
    const Framebuffer *target;
} TimedDraw;
/* `rounds` rounds, in each of which every draw is timed once, one after the other, repeated until it lasts long enough: by the
 * GPU's own clock where there is one, else by the wall clock. nanoseconds[i]: the median, for a pixel of its target. */
bool meter_time(Meter *meter, const TimedDraw *draws, int count, int rounds, double *nanoseconds);

/* A program of one constant colour, whose time is subtracted from others'. */
bool meter_make_constant(Meter *meter, Shader *made);

/* Seconds on the monotonic clock. */
double meter_now(void);
/* Sorts. */
double meter_median(double *values, int count);
#endif
