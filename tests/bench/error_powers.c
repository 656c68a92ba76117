/* x^32 by every implementation of the axis powers: the error in units in the last place, and the
 * time. */
#include "error.h"
#include "matbench.h"
#include "compiler/evaluate.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The picture fits into a cache, because powers are few instructions and writing many pixels
 * would take longer. */
enum {
    SIDE = 256,
    ROUNDS = 25,
    QUICK_ROUNDS = 7,
    BATCHES = 64,
    QUICK_BATCHES = 8,
    MOST = 8,
    EXPONENT = 32
};

/* Five successive squarings of x. */
static const char document_text[] =
    "material: Phong\n"
    "diffuse:\n"
    "  map: Gradient\n"
    "  direction: [1, 0, 0]\n"
    "  waveForm: { wave: Chain, first: Sqr, second: { wave: Chain, first: Sqr, second:\n"
    "    { wave: Chain, first: Sqr, second: { wave: Chain, first: Sqr, second: Sqr } } } }\n";

typedef struct {
    char name[VARIANT_NAME];
    MatcProgram *program;
    Material material;
    double ulp, nanoseconds;
} Power;

/* Distance between adjacent floats near a number. */
static double float_step(double v) { return ldexp(1, ilogb(v) - 23); }

/* Points with x uniform in [1/2, 3/2). */
static void make_points(FieldVertex points[POINTS], int batch)
{
    sample_points(points, 1);
    for (int i = 0; i < POINTS; i++) {
        double x = 0.5 + fraction((batch * POINTS + i + 1) * 0.6180339887498949);
        points[i].input[INPUT_X][0] = (float)x;
    }
}

/* Points of a batch, and their drawing. */
typedef struct {
    FieldVertex *points; /* POINTS */
    float (*rgba)[4];
} Batch;

static bool measure_batch(ErrorBench *bench, int number, Power *powers, int count, Batch batch)
{
    Field field;
    make_points(batch.points, number);
    bool done = field_make(bench->meter->gl, batch.points, POINTS, GL_POINTS, &field);
    for (int k = 0; k < count && done; k++) {
        done = meter_draw_points(bench->meter, &powers[k].material, &field, batch.rgba);
        for (int i = 0; i < POINTS && done; i++) {
            double wanted = pow(batch.points[i].input[INPUT_X][0], EXPONENT);
            powers[k].ulp =
                fmax(powers[k].ulp, fabs(batch.rgba[i][0] - wanted) / float_step(wanted));
        }
    }
    field_delete(bench->meter->gl, &field);
    return done;
}

static bool measure_times(ErrorBench *bench, Power *powers, int count)
{
    Material constant = {0};
    Field field = {0};
    Framebuffer target;
    FieldVertex plane[PLANE_VERTICES];
    MeterDraw draws[MOST + 1];
    double nanoseconds[MOST + 1];
    GlContext *gl = bench->meter->gl;
    sample_plane(plane, &(PlaneView){.scale = 1, .aspect = 1, .height = SIDE});
    const int side = SIDE * bench->factor * (bench->factor > 1 ? 2 : 1);
    FramebufferSpec spec = {
        .width = side, .height = side, .color_count = 1, .color_format = GL_RGBA16F};
    if (!framebuffer_make(gl, &spec, &target))
        return false;
    bool done = field_make(gl, plane, PLANE_VERTICES, GL_TRIANGLE_STRIP, &field) &&
                meter_make_constant(bench->meter, &constant);
    draws[0] = (MeterDraw){&constant, &field, &target};
    for (int i = 0; i < count; i++)
        draws[1 + i] = (MeterDraw){&powers[i].material, &field, &target};
    done = done && meter_time(bench->meter, draws, count + 1, bench->quick ? QUICK_ROUNDS : ROUNDS,
                              nanoseconds);
    for (int i = 0; i < count && done; i++)
        powers[i].nanoseconds = fmax(0, nanoseconds[1 + i] - nanoseconds[0]);
    material_delete(&constant);
    field_delete(gl, &field);
    framebuffer_delete(gl, &target);
    return done;
}

static const Power *find(const Power *powers, int count, const char *choice)
{
    char name[VARIANT_NAME];
    snprintf(name, sizeof name, "powers=%s", choice);
    for (int i = 0; i < count; i++)
        if (!strcmp(powers[i].name, name))
            return &powers[i];
    return NULL;
}

static bool is_same(const Power *a, const Power *b)
{
    return variant_programs_equal(matc_output(a->program, MATC_FRAGMENT, NULL),
                                  matc_output(b->program, MATC_FRAGMENT, NULL));
}

static void report(ErrorBench *bench, const Power *powers, int count)
{
    FILE *out = bench->part[SECTION_PART_powers];
    const Power *squaring = find(powers, count, "squaring"), *call = find(powers, count, "pow");
    const Power *exact = find(powers, count, "compensated");
    fputs("| x^32, x in [1/2, 3/2) | greatest error, ULP | ns a pixel |\n| --- | --- | --- |\n",
          out);
    for (int i = 0; i < count; i++) {
        fprintf(out, "| %s | %.2f | %.3f |\n", powers[i].name, powers[i].ulp,
                powers[i].nanoseconds);
        const ErrorSubject of = {"power", "x^32", powers[i].name};
        error_figure(bench, of, "ulp", powers[i].ulp);
        error_figure(bench, of, "ns_per_pixel", powers[i].nanoseconds);
    }
    if (squaring && call && is_same(squaring, call))
        error_target(bench, "x^32, powers=squaring", false,
                     "25 ULP, twice as fast as pow|both are one program");
    else if (squaring && call)
        error_target(bench, "x^32, powers=squaring",
                     squaring->ulp <= 25 && call->nanoseconds > 0 &&
                         2 * squaring->nanoseconds <= call->nanoseconds,
                     "25 ULP, twice as fast as pow|%.1f ULP, %.2f times as fast", squaring->ulp,
                     call->nanoseconds / fmax(squaring->nanoseconds, 1e-3));
    if (exact)
        error_target(bench, "x^32, powers=compensated", exact->ulp <= 1, "1 ULP|%.2f ULP",
                     exact->ulp);
}

static int make_powers(ErrorBench *bench, const MatcDocument *document, Power powers[MOST])
{
    Variant variant;
    MatcOptions options;
    int count = 0;
    matc_options_init(&options);
    options.aa = "none"; /* the mean of the wave would use no powers */
    for (int i = 0; i < axis_choices(AXIS_powers) && count < MOST; i++) {
        variant_of(&options, &variant);
        variant.choice[AXIS_powers] = axis_table[AXIS_powers].first + i;
        snprintf(powers[count].name, VARIANT_NAME, "powers=%s",
                 choice_table[variant.choice[AXIS_powers]].name);
        powers[count].program = error_program(document, &variant);
        count += powers[count].program &&
                 meter_make_material(bench->meter, powers[count].program, &powers[count].material);
    }
    return count;
}

void error_powers(ErrorBench *bench)
{
    Power *powers = calloc(MOST, sizeof *powers);
    FieldVertex *points = calloc(POINTS, sizeof *points);
    float(*rgba)[4] = calloc(POINTS, sizeof *rgba);
    if (!powers || !points || !rgba)
        abort();
    bench_show("powers");
    MatcDocument *document = error_document("powers", document_text);
    int count = make_powers(bench, document, powers);
    bool done = count > 0;
    for (int i = 0; i < (bench->quick ? QUICK_BATCHES : BATCHES) && done; i++)
        done = measure_batch(bench, i, powers, count, (Batch){points, rgba});
    if (done && measure_times(bench, powers, count))
        report(bench, powers, count);
    for (int i = 0; i < count; i++) {
        material_delete(&powers[i].material);
        matc_program_free(powers[i].program);
    }
    matc_document_free(document);
    free(rgba);
    free(points);
    free(powers);
}
