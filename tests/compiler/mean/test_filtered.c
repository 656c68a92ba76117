/* --aa as drawn, for pixels whose mean has a closed form: rectangles along the axes, whole
 * periods. */
#include "tests/test.h"
#include "tests/value/apart.h"
#include "tests/draw/sheet.h"
#include "tests/value/waves.h"
#include <stdio.h>
#include <string.h>

enum { MAX_SHOWN = 3, SLICES = 20000 };
static const char *const filters[] = {"box", "aniso"};
static const char *const targets[] = {"glsl330", "glsl110", "essl300"};
enum { WAYS = 6 }; /* a filter and a target */

static Drawers drawers;

static int set_up(void **state)
{
    (void)state;
    const char *fault = drawers_open(&drawers);
    if (fault)
        print_error("%s\n", fault);
    return fault != NULL;
}

static int tear_down(void **state)
{
    (void)state;
    drawers_close(&drawers);
    return 0;
}

static Filtered open(const char *slot, const char *map, int way)
{
    Filtered f = {.map = map, .slot = slot, .target = targets[way / 2], .aa = filters[way % 2]};
    if (!filtered_open(&f, &drawers))
        fail_msg("%s", f.error);
    return f;
}

typedef float Picture[SHEET_PIXELS][4];

static void draw(Filtered *f, const ContactSheet *sheet, Picture rgba)
{
    if (!filtered_draw(f, sheet, rgba))
        fail_msg("%s", f->error);
}

typedef struct {
    int failures;
    double worst, bound;
} Report;

static void compare(Report *report, double drawn, double want, const Filtered *f)
{
    double error = isnan(drawn) ? INFINITY : fabs(drawn - want);
    if (note(error, &report->worst) <= report->bound || report->failures++ >= MAX_SHOWN)
        return;
    print_error("%s, %s, %s: %.7g, not %.7g\n", f->map, f->target, f->aa, drawn, want);
}

static void end(const Report *report, const char *what)
{
    print_message("%-64.64s %.1e, at most %.1e\n", what, report->worst, report->bound);
    assert_int_equal(report->failures, 0);
}

/* Footprint of a pixel in x, y, z, the first two of which are u and v. */
typedef struct {
    double middle[3], edge[3];
} Box;

/* x and u change to the right, y and v upwards, and not alike. */
static ContactSheet straight_sheet(double width, double height)
{
    ContactSheet sheet;
    sheet_init(&sheet);
    contact_sheet_set(&sheet, 0, .137 * width, width, 0);
    contact_sheet_set(&sheet, 1, -.291 * height, 0, height);
    contact_sheet_set(&sheet, 2, .43, 0, 0);
    return sheet;
}

static Box box_of(const ContactSheet *sheet, int pixel)
{
    Surface s;
    Box box;
    sheet_surface(sheet, pixel, 0, 0, &s);
    for (int i = 0; i < 3; i++) {
        box.middle[i] = s.root[channel_id(GROUP_X, i)];
        box.edge[i] = (double)sheet->right.input[INPUT_X][i] + (double)sheet->up.input[INPUT_X][i];
    }
    return box;
}

static const double sizes[][2] = {
    {.03, .11}, {.31, .17}, {.83, 1.9}, {1.7, .6}, {4.3, 2.2}}; /* of a pixel, in periods */
enum { SIZES = sizeof sizes / sizeof *sizes };

/* The share of cells whose sum of indices is odd; `edge` is a cell's. */
static double odd_share(const Box *box, int components, double edge)
{
    double product = 1;
    for (int i = 0; i < components; i++)
        product *= mean_between(area_stripes, box->middle[i] / edge / 2, box->edge[i] / edge / 2);
    return (1 - product) / 2;
}

static double mean_checker(const Box *box) { return .1 + .8 * odd_share(box, 2, .5); }
static double mean_cubes(const Box *box) { return .1 + .8 * odd_share(box, 3, 1); }

/* A filter makes a function of the program: then changes over the screen stand outside of main().
 * Its mean of z is z. */
#define SMOOTHED_CHECKER                                                                           \
    "{ map: Checker, color1: { map: Smooth3D, input: { map: Gradient, direction: [0, 0, 1] } }, "  \
    "color2: 0.1 }"
static double mean_smoothed(const Box *box)
{
    return .1 + (box->middle[2] - .1) * odd_share(box, 2, .5);
}

/* Mean of ((sin x + sin y + sin z) / 3)^2 with independent components: the variances, and the
 * square of the sum of the means. */
static double mean_leopard(const Box *box)
{
    double sum = 0, variance = 0;
    for (int i = 0; i < 3; i++) {
        double mean = mean_between(area_sine, box->middle[i], box->edge[i]);
        double square = .5 - .5 * mean_between(area_cosine, 2 * box->middle[i], 2 * box->edge[i]);
        sum += mean;
        variance += square - mean * mean;
    }
    return (sum * sum + variance) / 9;
}

/* A line from each item to the next, a step at 1/4, the ends as they are. */
#define BLEND(input)                                                                               \
    "{ map: Blend, blend: [{ value: 0, input: 0.2 }, { value: 0.25, input: 1 }, { value: 0.25, "   \
    "input: 0 },"                                                                                  \
    " { value: 0.75, input: 0.6 }], input: " input " }"
static double area_blend(double t)
{
    if (t < 0)
        return .2 * t;
    if (t < .25)
        return .2 * t + 1.6 * t * t;
    return t < .75 ? .15 + .6 * (t - .25) * (t - .25) : .3 + .6 * (t - .75);
}
static double mean_blend(const Box *box)
{
    return mean_between(area_blend, box->middle[0], box->edge[0]);
}

/* The mean of what the blend makes of both colors, and not what it makes of their mean: at 0 it is
 * 0.1, at 1 0.3, at 1/2 0.9. */
#define BLENDED_CHECKER                                                                            \
    "{ map: Blend, blend: [{ value: 0, input: 0.1 }, { value: 0.5, input: 0.9 }, { value: 1, "     \
    "input: 0.3 }],"                                                                               \
    " input: { map: Checker } }"
static double mean_blended(const Box *box) { return .1 + .2 * odd_share(box, 2, .5); }

/* Mean of exponents: y = x (2 - x), n = -2 / ln y. */
static double exponent(double x) { return -2 / log(x * (2 - x)); }
static double mean_exponents(const Box *box)
{
    return exponent(.1) + (exponent(.9) - exponent(.1)) * odd_share(box, 2, .5);
}

/* Mean of a square root that is 0 below 0. Four samples of a pixel of width w have an error of at
 * most .0295 sqrt(w), where only a corner of it is above 0; the point in its center of .236
 * sqrt(w). */
static double area_root(double t) { return t > 0 ? t * sqrt(t) / 1.5 : 0; }
static double mean_root(const Box *box)
{
    return mean_between(area_root, box->middle[0] - .3, box->edge[0]);
}

static const struct {
    const char *slot, *map;
    double (*mean)(const Box *box);
    double period, bound;
} box_cases[] = {
    {"emissive", "{ map: Checker, color1: 0.9, color2: 0.1 }", mean_checker, 1, 4e-6},
    {"emissive", "{ map: VolumeChecker, color1: 0.9, color2: 0.1 }", mean_cubes, 2, 4e-6},
    {"emissive", SMOOTHED_CHECKER, mean_smoothed, 1, 4e-6},
    {"emissive", "{ map: Leopard }", mean_leopard, 2 * M_PI, 2e-6},
    {"emissive", BLEND("{ map: Gradient }"), mean_blend, 1, 4e-6},
    {"emissive", BLENDED_CHECKER, mean_blended, 1, 1e-6},
    {"shininess",
     "{ map: Blend, blend: [{ value: 0, input: 0.1 }, { value: 1, input: 0.9 }], input: { map: "
     "Checker } }",
     mean_exponents, 1, 9e-4},
    {"emissive", "{ map: Expression, is: \"sqrt(x - .3)\" }", mean_root, 1, .0295 * 2.0737},
};

static void rectangles_show_means(void **state)
{
    (void)state;
    static Picture rgba;
    for (size_t i = 0; i < sizeof box_cases / sizeof *box_cases; i++) {
        Report report = {.bound = box_cases[i].bound};
        for (int way = 0; way < WAYS; way++) {
            Filtered f = open(box_cases[i].slot, box_cases[i].map, way);
            for (int size = 0; size < SIZES; size++) {
                ContactSheet sheet = straight_sheet(box_cases[i].period * sizes[size][0],
                                                    box_cases[i].period * sizes[size][1]);
                draw(&f, &sheet, rgba);
                for (int pixel = 0; pixel < SHEET_PIXELS; pixel++) {
                    Box box = box_of(&sheet, pixel);
                    compare(&report, rgba[pixel][0], box_cases[i].mean(&box), &f);
                }
            }
            filtered_close(&f);
        }
        end(&report, box_cases[i].map);
    }
}

/* A wave along x, which changes to the right, or along y, which changes upwards. */
static void compare_wave(const WaveCurve *wave, int axis, int way, Report *report)
{
    static Picture rgba;
    const double frequency = 1.5, phase = .21,
                 period = (wave->period ? wave->period : 1) / frequency;
    char map[256];
    snprintf(map, sizeof map,
             "{ map: Gradient, waveForm: %s, frequency: %g, phase: %g, direction: [%d, %d, 0] }",
             wave->name, frequency, phase, !axis, axis);
    Filtered f = open("emissive", map, way);
    for (int k = 0; k < SIZES; k++) {
        ContactSheet sheet = straight_sheet(period * sizes[k][0], period * sizes[k][1]);
        draw(&f, &sheet, rgba);
        for (int pixel = 0; pixel < SHEET_PIXELS; pixel++) {
            Box box = box_of(&sheet, pixel);
            double want = mean_between(wave->area, frequency * box.middle[axis] + phase,
                                       frequency * box.edge[axis]);
            double scale = fmax(1, fabs(want));
            compare(report, rgba[pixel][0] / scale, want / scale, &f);
        }
    }
    filtered_close(&f);
}

typedef struct {
    double square, bias; /* root mean square error; the greatest mean error of a width */
} PartErrors;

/* By wave, in their order. `mean`: of a mean over a box, over the greatest of 1 and the mean;
 * runtime/lib/ states those of narrow boxes. `part`: of what
 * parts_of_periods_leave_about_their_variance draws. */
static const struct {
    double mean;
    PartErrors part;
} bounds[WAVE_CURVES] = {
    {1e-5, {0, 0}},       {1e-5, {0, 0}},       {1e-5, {0, 0}},
    {1e-5, {0, 0}},                                                   /* Abs, Ceil, Floor, Sqr */
    {1e-5, {.064, .087}}, {1e-5, {.064, .087}}, {1e-5, {.064, .087}}, /* Cos, Sin, Sin01 */
    {1e-5, {.067, .066}}, {5e-4, {.086, .084}}, {1e-5, {.044, .057}},
    {8e-4, {.055, .066}}, /* Ramp, Cubic, Triangle, Scallop */
};

static void waves_show_means(void **state)
{
    (void)state;
    for (int i = 0; i < WAVE_CURVES; i++) {
        Report report = {.bound = bounds[i].mean};
        for (int way = 0; way < WAYS; way++)
            compare_wave(&wave_curves[i], (way + way / 2) % 2, way, &report);
        end(&report, wave_curves[i].name);
    }
}

/* The square of 0.7 W + 0.3: its mean over a period shows all of W's variance. */
static Curve *squared;
static double square_of_wave(double v) { return pow(.7 * squared(v) + .3, 2); }

static Filtered open_square(const WaveCurve *wave, char map[256], int way)
{
    snprintf(map, 256,
             "{ map: Gradient, waveForm: { wave: Chain, first: %s, factor: 0.7, shift: 0.3, "
             "second: Sqr } }",
             wave->name);
    squared = wave->wave;
    return open("emissive", map, way);
}

static void whole_periods_leave_all_of_the_variance(void **state)
{
    (void)state;
    static Picture rgba;
    for (const WaveCurve *wave = wave_curves; wave < wave_curves + WAVE_CURVES; wave++) {
        char map[256];
        Report report = {.bound = 5e-5};
        if (!wave->period)
            continue;
        for (int k = 0; k < 4; k++) {
            Filtered f = open_square(wave, map, k % 2);
            ContactSheet sheet = straight_sheet((1 + k / 2) * wave->period, 0);
            double want = mean_of_slices(square_of_wave, 0, wave->period, SLICES);
            draw(&f, &sheet, rgba);
            for (int pixel = 0; pixel < SHEET_PIXELS; pixel++)
                compare(&report, rgba[pixel][0], want, &f);
            filtered_close(&f);
        }
        end(&report, wave->name);
    }
}

/* Functions linear in a Ramp or Triangle are exact, too: these are distributed evenly over [-1, 1].
 * */
static void whole_periods_of_even_waves_are_boxes(void **state)
{
    (void)state;
    static Picture rgba;
    static const char *const maps[] = {BLEND("{ map: Gradient, waveForm: Ramp }"),
                                       BLEND("{ map: Gradient, waveForm: Triangle }")};
    Report report = {.bound = 2e-6};
    for (int k = 0; k < 4; k++) {
        Filtered f = open("emissive", maps[k / 2], k % 2);
        ContactSheet sheet = straight_sheet(2, 0);
        draw(&f, &sheet, rgba);
        for (int pixel = 0; pixel < SHEET_PIXELS; pixel++)
            compare(&report, rgba[pixel][0], mean_between(area_blend, 0, 2), &f);
        filtered_close(&f);
    }
    end(&report, "Blend over Ramp, Triangle");
}

/* Over less than a period, a part of the variance shows in the mean's slope, and the rest is
 * estimated: root mean square errors of the square over boxes of 0.1 to 2.6 periods, with values
 * from 0 to 1. */
static PartErrors part_errors(const WaveCurve *wave)
{
    static Picture rgba;
    char map[256];
    PartErrors errors = {0, 0};
    int steps = 0;
    Filtered f = open_square(wave, map, 0);
    for (double periods = .1; periods < 2.65; periods += .25, steps++) {
        double bias = 0;
        ContactSheet sheet = straight_sheet(periods * wave->period, 0);
        draw(&f, &sheet, rgba);
        for (int pixel = 0; pixel < SHEET_WIDTH; pixel++) {
            Box box = box_of(&sheet, pixel);
            double want = mean_of_slices(square_of_wave, box.middle[0], box.edge[0], SLICES / 10);
            errors.square += pow(rgba[pixel][0] - want, 2) / SHEET_WIDTH;
            bias += (rgba[pixel][0] - want) / SHEET_WIDTH;
        }
        errors.bias = fmax(errors.bias, fabs(bias));
    }
    filtered_close(&f);
    errors.square = sqrt(errors.square / steps);
    return errors;
}

static void parts_of_periods_leave_about_their_variance(void **state)
{
    (void)state;
    for (int i = 0; i < WAVE_CURVES; i++) {
        if (!wave_curves[i].period)
            continue;
        PartErrors seen = part_errors(&wave_curves[i]), most = bounds[i].part;
        print_message("%-64s %.4f, at most %.4f; bias %.4f, at most %.4f\n", wave_curves[i].name,
                      seen.square, most.square, seen.bias, most.bias);
        assert_true(seen.square <= most.square && seen.bias <= most.bias);
    }
}

/* Smooth3D and Laplace3D do not filter their input, since they sample it themselves: it has the
 * values of points, however wide the pixel is, and so has everything that depends on it. */
#define NOISE "{ map: VolumeTurbulence, noiseRatio: 0.5 }"
static const char *const sampled_maps[] = {
    "{ map: Smooth3D, input: " NOISE " }",
    "{ map: Laplace3D, sx: 0.3, input: { map: Checker } }",
    "{ map: Smooth3D, sx: 0.4, input: { map: Gradient, waveForm: Ramp } }",
    BLEND("{ map: Smooth3D, input: " NOISE " }"),
    BLEND("{ map: Smooth3D, input: { map: VolumeTurbulence, noiseRatio: 0.5, input: { map: "
          "XYZTransform, useGlobal: "
          "true } } }"),
};

static void filters_show_points(void **state)
{
    (void)state;
    static Picture rgba;
    for (size_t i = 0; i < sizeof sampled_maps / sizeof *sampled_maps; i++) {
        Report report = {.bound = 5e-5};
        for (int way = 0; way < 2; way++) {
            Filtered f = open("emissive", sampled_maps[i], way);
            ContactSheet sheet = straight_sheet(.83, 1.71);
            Oracle *oracle =
                oracle_open(f.document.graph, &(ReferenceContext){.noise = REFERENCE_LATTICE});
            draw(&f, &sheet, rgba);
            for (int pixel = 0; pixel < SHEET_PIXELS; pixel++) {
                Surface surface;
                SlotValues values;
                sheet_surface(&sheet, pixel, 0, 0, &surface);
                oracle_material(oracle, f.document.graph->materials[0].node, &surface, &values);
                compare(&report, rgba[pixel][0], values.component[SLOT_emissive][0], &f);
            }
            oracle_close(oracle);
            filtered_close(&f);
        }
        end(&report, sampled_maps[i]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rectangles_show_means),
        cmocka_unit_test(waves_show_means),
        cmocka_unit_test(whole_periods_leave_all_of_the_variance),
        cmocka_unit_test(whole_periods_of_even_waves_are_boxes),
        cmocka_unit_test(parts_of_periods_leave_about_their_variance),
        cmocka_unit_test(filters_show_points),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
