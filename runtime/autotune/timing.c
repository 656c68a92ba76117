/* Measures the time of draws by the GPU's timer or the wall clock. */
#include "runtime/autotune/meter.h"
#include "runtime/gl/clock.h"
#include "runtime/gl/message.h"
#include <stdlib.h>
#include <time.h>

enum { MAX_REPEATS = 1 << 14 };
/* min sample length in seconds, large compared with the overhead of clock and queue */
static const double least_sample = 2.5e-3;

double meter_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double meter_median(double *values, int count)
{
    qsort(values, (size_t)count, sizeof *values, by_value);
    return count % 2 ? values[count / 2] : (values[count / 2 - 1] + values[count / 2]) / 2;
}

static void repeat(const GlContext *gl, const Field *field, int repeats)
{
    for (int i = 0; i < repeats; i++)
        field_draw(gl, field);
}

static double seconds_by_gpu(const GlContext *gl, const Field *field, int repeats)
{
    const GLuint query = gl_clock_start(gl);
    repeat(gl, field, repeats);
    return gl_clock_stop(gl, query);
}

static double seconds_by_wall(const GlContext *gl, const Field *field, int repeats)
{
    gl->Finish();
    double start = meter_now();
    repeat(gl, field, repeats);
    gl->Finish();
    return meter_now() - start;
}

static double time_once(Meter *m, const MeterDraw *draw, int repeats)
{
    meter_use(m, draw, (float[2]){0, 0});
    return gl_clock_is(m->gl) ? seconds_by_gpu(m->gl, draw->field, repeats)
                              : seconds_by_wall(m->gl, draw->field, repeats);
}

/* Returns the repeat count of a sample. The first draw triggers compilation; then the count
 * doubles until a sample is long enough. */
static int find_repeats(Meter *m, const MeterDraw *draw)
{
    int repeats = 1;
    time_once(m, draw, 1);
    while (repeats < MAX_REPEATS && time_once(m, draw, repeats) < least_sample)
        repeats *= 2;
    return repeats;
}

bool meter_time(Meter *m, const MeterDraw *draws, int count, int rounds, double *nanoseconds)
{
    int *repeats = calloc((size_t)count, sizeof *repeats);
    double *seconds = calloc((size_t)count * (size_t)rounds, sizeof *seconds);
    if (!repeats || !seconds)
        abort();
    for (int i = 0; i < count; i++)
        repeats[i] = find_repeats(m, &draws[i]);
    for (int round = 0; round < rounds; round++)
        for (int i = 0; i < count; i++)
            seconds[i * rounds + round] = time_once(m, &draws[i], repeats[i]) / repeats[i];
    for (int i = 0; i < count; i++) {
        const FramebufferSpec *spec = &draws[i].target->spec;
        nanoseconds[i] =
            meter_median(seconds + i * rounds, rounds) * 1e9 / ((double)spec->width * spec->height);
    }
    free(repeats);
    free(seconds);
    return gl_check(m->gl, "timing") || message_fail(m->error, sizeof m->error, "%s", m->gl->error);
}
