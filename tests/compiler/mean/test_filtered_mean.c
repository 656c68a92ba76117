/* --aa as drawn over parallelograms, against means of the C reference over points within them;
 * noise by its statistics. MEAN_PLACES=N in the environment tries N places for each, and prints
 * the worst. */
/* ctest: unsanitized */
#include "tests/test.h"
#include "compiler/library/java_random.h"
#include "tests/value/apart.h"
#include "tests/draw/sheet.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    SIDE = 9,      /* samples of a pixel, an axis */
    STEP = 11,     /* to the next pixel that is looked at */
    POINTS = 20000 /* of which noise's statistics are made */
};
enum { BOX, ANISO, FILTERS };
static const char *const filters[] = {"box", "aniso"};
typedef float Picture[SHEET_PIXELS][4];

static Drawers drawers;

static int places(void)
{
    const char *reported = getenv("MEAN_PLACES");
    return reported ? atoi(reported) : 1;
}

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

static void draw(Filtered *f, const ContactSheet *sheet, Picture rgba)
{
    if (!filtered_draw(f, sheet, rgba))
        fail_msg("%s", f->error);
}

/* All of the coordinates change both ways, and none as another does. */
static ContactSheet turned_sheet(double size, double away)
{
    ContactSheet sheet;
    sheet_init(&sheet);
    contact_sheet_set(&sheet, 0, .137 + 37.31 * away, .91 * size, -.19 * size);
    contact_sheet_set(&sheet, 1, -.291 + 41.17 * away, .33 * size, .47 * size);
    contact_sheet_set(&sheet, 2, .43 - 29.83 * away, .23 * size, .11 * size);
    return sheet;
}

static double value_at(Oracle *oracle, const Filtered *f, const Surface *surface)
{
    SlotValues values;
    oracle_material(oracle, f->document.graph->materials[0].node, surface, &values);
    return values.component[SLOT_emissive][0];
}

static double mean_over(Oracle *oracle, const Filtered *f, const ContactSheet *sheet, int pixel)
{
    double sum = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        Surface surface;
        sheet_surface(sheet, pixel, (i % SIDE + .5) / SIDE - .5, (i / SIDE + .5) / SIDE - .5,
                      &surface);
        sum += value_at(oracle, f, &surface);
    }
    return sum / (SIDE * SIDE);
}

/* Errors over pixels of several sizes: root mean square, mean, and the slope of the drawn value
 * against the true mean, by least squares, which is 1 if a mean fades as it should. */
typedef struct {
    double square, bias, slope;
} Errors;

/* Sums over pixels. */
typedef struct {
    double count, drawn, want, drawn_drawn, drawn_want, want_want;
} Sums;

static void add(Sums *s, double drawn, double want)
{
    s->count++;
    s->drawn += drawn;
    s->want += want;
    s->drawn_drawn += drawn * drawn;
    s->drawn_want += drawn * want;
    s->want_want += want * want;
}

static Errors errors_of(const Sums *s)
{
    double n = s->count, covariance = s->drawn_want / n - s->drawn * s->want / n / n;
    return (Errors){.square = sqrt((s->drawn_drawn - 2 * s->drawn_want + s->want_want) / n),
                    .bias = (s->drawn - s->want) / n,
                    .slope = covariance / (s->drawn_drawn / n - s->drawn * s->drawn / n / n)};
}

static void open(Filtered f[FILTERS], const char *map, const char *noise)
{
    for (int i = 0; i < FILTERS; i++) {
        f[i] = (Filtered){.map = map, .slot = "emissive", .aa = filters[i], .noise = noise};
        if (!filtered_open(&f[i], &drawers))
            fail_msg("%s", f[i].error);
    }
}

static void close(Filtered f[FILTERS])
{
    for (int i = 0; i < FILTERS; i++)
        filtered_close(&f[i]);
}

static double far_of(double a, double b) { return fabs(a) > fabs(b) ? a : b; }

/* Each of the three where it is greatest. */
static void note_errors(const Sums *sums, Errors *worst)
{
    const Errors seen = errors_of(sums);
    worst->square = far_of(worst->square, seen.square);
    worst->bias = far_of(worst->bias, seen.bias);
    worst->slope = 1 + far_of(worst->slope - 1, seen.slope - 1);
}

static void measure(Filtered f[FILTERS], double period, int place, Errors worst[FILTERS])
{
    static const double sizes[] = {.2, .45, 1.1};
    static Picture rgba[FILTERS];
    Sums sums[FILTERS] = {0};
    Oracle *oracle = filtered_oracle(f);
    for (int size = 0; size < 3; size++) {
        ContactSheet sheet = turned_sheet(sizes[size] * period, place * period);
        for (int i = 0; i < FILTERS; i++)
            draw(&f[i], &sheet, rgba[i]);
        for (int pixel = 0; pixel < SHEET_PIXELS; pixel += STEP) {
            double want = mean_over(oracle, f, &sheet, pixel);
            for (int i = 0; i < FILTERS; i++)
                add(&sums[i], rgba[i][pixel][0], want);
        }
    }
    oracle_close(oracle);
    for (int i = 0; i < FILTERS; i++)
        note_errors(&sums[i], &worst[i]);
}

/* At one place, what is seen and a few hundredths more. A few dozen pixels know no more of noise:
 * elsewhere they see others, of MEAN_PLACES=64 the worst is up to three times the bias, for every
 * noise alike. Whether places differ as chance has it is test_statistics' to tell. */
static const struct {
    const char *map, *noise;
    double period;
    Errors most[FILTERS]; /* box, aniso; of the slope how far it is from 1 */
} cases[] = {
    {"{ map: Checker }", NULL, 1, {{.0569, .0066, .039}, {.0252, .0041, .020}}},
    {"{ map: VolumeChecker }", NULL, 2, {{.0735, .0017, .042}, {.0476, .0014, .035}}},
    {"{ map: Leopard }", NULL, 2 * M_PI, {{.0271, .0023, .020}, {.0108, .0015, .005}}},
    {"{ map: Gradient, direction: [0.8, -0.5, 0.3], waveForm: Triangle }",
     NULL,
     1,
     {{.0197, .0009, .011}, {.0197, .0009, .011}}},
    {"{ map: Gradient, direction: [0.8, -0.5, 0.3], waveForm: Ramp }",
     NULL,
     1,
     {{.0302, .0035, .016}, {.0302, .0035, .016}}},
    {"{ map: Blend, blend: [{ value: 0, input: 0.1 }, { value: 0.5, input: 0.9 }, { value: 1, "
     "input: 0.3 }], input: { "
     "map: Gradient, "
     "direction: [0.8, -0.5, 0.3] } }",
     NULL,
     1,
     {{.0007, .0006, .002}, {.0007, .0006, .002}}},
    {"{ map: Mandel }", NULL, 1, {{.1368, .0085, .081}, {.1368, .0085, .081}}},
    {"{ map: VolumeTurbulence, octaves: 1 }",
     "lattice",
     1,
     {{.0939, .0007, .083}, {.0285, .0013, .025}}},
    {"{ map: VolumeTurbulence, octaves: 1 }",
     "groimp",
     1,
     {{.0910, .0032, .086}, {.0287, .0019, .035}}},
    {"{ map: VolumeTurbulence, octaves: 1 }",
     "simplex",
     .5,
     {{.0775, .0085, .070}, {.0232, .0017, .025}}},
    {"{ map: VolumeTurbulence, octaves: 3, noiseRatio: 0.6 }",
     "lattice",
     1,
     {{.1536, .0119, .082}, {.0634, .0053, .029}}},
    {"{ map: VolumeTurbulence, octaves: 1, waveForm: Sqr }",
     "lattice",
     1,
     {{.0836, .0039, .106}, {.0422, .0138, .038}}},
    {"{ map: VolumeTurbulence, octaves: 1, waveForm: Sqr }",
     "groimp",
     1,
     {{.0846, .0072, .121}, {.0350, .0101, .053}}},
    {"{ map: VolumeTurbulence, octaves: 1, waveForm: Sqr }",
     "simplex",
     .5,
     {{.0672, .0105, .067}, {.0521, .0121, .047}}},
    {"{ map: Granite }", "lattice", .25, {{.1132, .0121, .120}, {.0507, .0061, .053}}},
    {"{ map: Granite }", "groimp", .25, {{.0939, .0045, .071}, {.0483, .0019, .029}}},
    {"{ map: Granite }", "simplex", .125, {{.1076, .0015, .112}, {.0492, .0013, .064}}},
    {"{ map: Granite, waveForm: Sqr }",
     "lattice",
     .25,
     {{.0531, .0017, .060}, {.0344, .0090, .054}}},
    {"{ map: Checker, input: { map: Turbulence, noiseRatio: 0.5 } }",
     "lattice",
     1,
     {{.0666, .0059, .014}, {.0396, .0022, .025}}},
};

static bool compare(const Filtered *f, const Errors *seen, const Errors *most)
{
    bool fine = seen->square <= most->square && fabs(seen->bias) <= most->bias &&
                fabs(seen->slope - 1) <= most->slope;
    print_message("%-60.60s %-5s error %.4f (%.4f), bias %7.4f (%.4f), slope %.3f (1 +- %.3f)%s\n",
                  f->map, f->aa, seen->square, most->square, seen->bias, most->bias, seen->slope,
                  most->slope, fine ? "" : "  TOO MUCH");
    return fine;
}

static void parallelograms_show_about_their_means(void **state)
{
    (void)state;
    int failures = 0;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Filtered f[FILTERS];
        Errors seen[FILTERS] = {{.slope = 1}, {.slope = 1}};
        open(f, cases[i].map, cases[i].noise);
        for (int place = 0; place < places(); place++)
            measure(f, cases[i].period, place, seen);
        for (int k = 0; k < FILTERS; k++)
            failures += !compare(&f[k], &seen[k], &cases[i].most[k]);
        close(f);
    }
    assert_int_equal(failures, 0);
}

/* Many periods of noise in every pixel, over which x + y + z stays the same. */
static ContactSheet wide_sheet(int place)
{
    ContactSheet sheet;
    sheet_init(&sheet);
    contact_sheet_set(&sheet, 0, .5 + 37.31 * place, 37, 20.5);
    contact_sheet_set(&sheet, 1, -.25 + 41.17 * place, -37, 20.5);
    contact_sheet_set(&sheet, 2, .125 - 78.48 * place, 0, -41);
    return sheet;
}

/* Statistics that remain of noise: mean and mean square of values, of magnitudes, and of
 * Turbulence's offsets. Components of GroIMP's vectors are slightly correlated, by its table of 512
 * numbers. At one place: 20,000 points know a mean to .0034 of their own. */
static const struct {
    const char *map;
    double most[3]; /* by noise */
} wide_cases[] = {
    {"{ map: VolumeTurbulence, octaves: 1 }", {.0009, .0039, .0011}},
    {"{ map: VolumeTurbulence, octaves: 4, noiseRatio: 0.7 }", {.0009, .0036, .0021}},
    {"{ map: VolumeTurbulence, octaves: 1, waveForm: Sqr }", {.0031, .0029, .0046}},
    {"{ map: VolumeTurbulence, octaves: 4, noiseRatio: 0.7, waveForm: Sqr }",
     {.0089, .0020, .0060}},
    {"{ map: Granite }", {.0018, .0079, .0055}},
    {"{ map: Granite, waveForm: Sqr }", {.0025, .0020, .0057}},
    /* the root of .65 of the variance for the mean of the magnitude */
    {"'= turbulence(p, 1)'", {.011, .011, .011}},
    {"'= turbulence(p, 4, 2, .7)'", {.03, .03, .03}},
    {"{ map: Gradient, direction: [1, 1, 1], waveForm: Sqr, input: { map: Turbulence, amount: [1, "
     "1, 1], octaves: 1 } "
     "}",
     {.0048, .0158, .0063}},
};
static const char *const noises[] = {"lattice", "groimp", "simplex"};

static double mean_of_points(const Filtered *f, const ContactSheet *sheet)
{
    double sum = 0;
    uint64_t random = java_random(7);
    Oracle *oracle = filtered_oracle(f);
    for (int i = 0; i < POINTS; i++) {
        Surface surface;
        double right = java_random_signed(&random), up = java_random_signed(&random);
        sheet_surface(sheet, i % SHEET_PIXELS, right / 2, up / 2, &surface);
        sum += value_at(oracle, f, &surface) / POINTS;
    }
    oracle_close(oracle);
    return sum;
}

/* The greatest difference from `want` over all pixels. */
static double off_by(Filtered *f, const ContactSheet *sheet, double want)
{
    static Picture rgba;
    double worst = 0;
    draw(f, sheet, rgba);
    for (int pixel = 0; pixel < SHEET_PIXELS; pixel++)
        note(isnan(rgba[pixel][0]) ? INFINITY : fabs(rgba[pixel][0] - want), &worst);
    return worst;
}

static bool compare_wide(Filtered f[FILTERS], double most)
{
    double worst[FILTERS] = {0};
    bool fine = true;
    for (int place = 0; place < places(); place++) {
        const ContactSheet sheet = wide_sheet(place);
        const double want = mean_of_points(f, &sheet);
        for (int k = 0; k < FILTERS; k++)
            note(off_by(&f[k], &sheet, want), &worst[k]);
    }
    for (int k = 0; k < FILTERS; k++) {
        print_message("%-70.70s %-7s %-5s off by %.4f (%.4f)%s\n", f->map, f->noise, f[k].aa,
                      worst[k], most, worst[k] <= most ? "" : "  TOO MUCH");
        fine &= worst[k] <= most;
    }
    return fine;
}

static void wide_pixels_show_statistics(void **state)
{
    (void)state;
    int failures = 0;
    for (size_t i = 0; i < sizeof wide_cases / sizeof *wide_cases * 3; i++) {
        Filtered f[FILTERS];
        open(f, wide_cases[i / 3].map, noises[i % 3]);
        failures += !compare_wide(f, wide_cases[i / 3].most[i % 3]);
        close(f);
    }
    assert_int_equal(failures, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parallelograms_show_about_their_means),
        cmocka_unit_test(wide_pixels_show_statistics),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
