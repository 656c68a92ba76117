/* GL context for measurements: draws points and views, times draws, and reads G-buffers back.
 * Not thread-safe. */
#ifndef MATC_AUTOTUNE_METER_H
#define MATC_AUTOTUNE_METER_H
#include "runtime/gpu_material/reader.h"
#include "runtime/autotune/sample.h"

typedef struct {
    GlContext *gl;
    Store *store;
    Framebuffer numbers;              /* RGBA32F target with one pixel per point */
    Framebuffer packed[LAYOUT_COUNT]; /* G-buffers of the points by layout, created on first use */
    Reader readers[LAYOUT_COUNT];     /* programs that unpack `packed` */
    /* the driver or the GL layer lacks the layout's render targets */
    bool refused[LAYOUT_COUNT];
    char error[4096];
} Meter;

/* A draw to be timed: material, mesh and target. */
typedef struct {
    Material *material;
    const Field *field;
    const Framebuffer *target;
} MeterDraw;

/* Opens a context and makes it current. Returns NULL with the reason in `error`. */
Meter *meter_open(GlKind kind, char *error, size_t capacity);
void meter_close(Meter *meter);

/* Creates the material of a GLSL 3.30 program, which the caller keeps. Returns false with the
 * reason in meter->error; *made is then empty. */
bool meter_make_material(Meter *meter, MatcProgram *program, Material *made);

/* Creates the render targets of a layout. Returns false with the reason in meter->error. */
bool meter_make_targets(Meter *meter, Layout layout, int width, int height, Framebuffer *made);

/* Binds target and material for a draw, with a subpixel jitter in clip space. */
void meter_use(const Meter *meter, const MeterDraw *draw, const float jitter[2]);

/* Draws points with a program of pass value. `rgba` receives four floats per point. */
bool meter_draw_points(Meter *meter, Material *material, const Field *points, float (*rgba)[4]);

/* Creates the layout's targets and its unpacking reader on first use. `unpack` is the output
 * MATC_UNPACK of the layout. */
bool meter_open_layout(Meter *meter, Layout layout, const char *unpack);
/* Draws points with a program of pass gbuffer and unpacks their slots. meter_open_layout must
 * have succeeded for the layout. Slots missing from the layout are NaN. */
bool meter_draw_packed(Meter *meter, Material *material, Layout layout, const Field *points,
                       SlotValues *values);

/* Returns the mean of n x n draws with a program of pass value, each jittered within its cell of
 * the pixel. `rgba` receives four floats per pixel. n = 1 draws the picture without jitter. The
 * target must be RGBA32F. */
bool meter_draw_mean(Meter *meter, const MeterDraw *draw, int n, float *rgba);

/* Times draws in `rounds` rounds. Each round times every draw once, repeated until the sample is
 * long enough. Uses GPU timer queries if supported, else the wall clock. nanoseconds[i] is the
 * median per pixel of the draw's target. */
bool meter_time(Meter *meter, const MeterDraw *draws, int count, int rounds, double *nanoseconds);

/* Creates a program of one constant color, whose time is subtracted from all others. */
bool meter_make_constant(Meter *meter, Material *made);

/* Returns the monotonic clock in seconds. */
double meter_now(void);
/* Returns the median; sorts `values`. */
double meter_median(double *values, int count);
#endif
