/* A context to measure in: draws points and views, times draws, reads G-buffers back. For one
 * thread. */
#ifndef MATC_MEASURE_METER_H
#define MATC_MEASURE_METER_H
#include "runtime/draw/reader.h"
#include "runtime/measure/sample.h"

typedef struct {
    GlContext *gl;
    Store *store;
    Framebuffer numbers;              /* RGBA32F, a pixel a point */
    Framebuffer packed[LAYOUT_COUNT]; /* the same in a layout's format; made when first asked for */
    Reader readers[LAYOUT_COUNT];     /* of these */
    bool refused[LAYOUT_COUNT];       /* the driver, or the GL layer, has no such target */
    char error[4096];
} Meter;

/* A drawing to be timed: material, mesh and target. */
typedef struct {
    Material *material;
    const Field *field;
    const Framebuffer *target;
} MeterDraw;

/* NULL: see `error`. The context is current afterwards. */
Meter *meter_open(GlKind kind, char *error, size_t room);
void meter_close(Meter *meter);

/* A material of a program in GLSL 3.30, which stays the caller's. False: see meter->error; *made is
 * empty. */
bool meter_make_material(Meter *meter, MatcProgram *program, Material *made);

/* The render targets of a layout, of any size. False: see meter->error. */
bool meter_make_targets(Meter *meter, Layout layout, int width, int height, Framebuffer *made);

/* Puts all into place but the draw itself, the picture moved by a jitter in clip space. */
void meter_use(const Meter *meter, const MeterDraw *draw, const float jitter[2]);

/* Draws points by a program of pass value: four floats a point. */
bool meter_draw_points(Meter *meter, Material *material, const Field *points, float (*rgba)[4]);

/* Makes what reads a layout back, once: `unpack` is MATC_UNPACK of that layout. */
bool meter_open_layout(Meter *meter, Layout layout, const char *unpack);
/* Draws points by a program of pass gbuffer, and reads the slots back, of a layout that was opened.
 * Slots that the layout does not hold are NaN. */
bool meter_draw_packed(Meter *meter, Material *material, Layout layout, const Field *points,
                       SlotValues *values);

/* The mean of n x n draws by a program of pass value, each moved within its part of a pixel: four
 * floats a pixel. n = 1 is the picture itself. The target is one of RGBA32F. */
bool meter_draw_mean(Meter *meter, const MeterDraw *draw, int n, float *rgba);

/* `rounds` rounds, in each of which every draw is timed once, one after the other, repeated until
 * it lasts long enough: by the GPU's own clock where there is one, else by the wall clock.
 * nanoseconds[i]: the median, for a pixel of its target. */
bool meter_time(Meter *meter, const MeterDraw *draws, int count, int rounds, double *nanoseconds);

/* A program of one constant colour, whose time is subtracted from others'. */
bool meter_make_constant(Meter *meter, Material *made);

/* Seconds on the monotonic clock. */
double meter_now(void);
/* Sorts. */
double meter_median(double *values, int count);
#endif
