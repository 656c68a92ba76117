/* SunSkyLight against the paper: Preetham, Shirley and Smits, A Practical Analytic Model for
 * Daylight (1999), with the numbers of its appendix typed in here, and the sun's color by the
 * CIE's 1931 table, for which the product has a fit. */
#include "tests/test.h"
#include "compiler/matc.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BANDS = 38, FIRST_NM = 380, STEP_NM = 10, RINGS = 300, SECTORS = 300 };

/* 380 to 750 nm: the sun above the air, W/(cm2 um sr); absorption of ozone and of water vapour,
 * 1/cm; the standard observer. */
static const struct {
    double sun, ozone, water, x, y, z;
} bands[BANDS] = {
    {165.5, .003 * 25 / 90, 0, .0014, .0000, .0065},
    {162.3, .003 * 35 / 90, 0, .0042, .0001, .0201},
    {211.2, .003 * 45 / 90, 0, .0143, .0004, .0679},
    {258.8, .003 * 55 / 90, 0, .0435, .0012, .2074},
    {258.2, .003 * 65 / 90, 0, .1344, .0040, .6456},
    {242.3, .003 * 75 / 90, 0, .2839, .0116, 1.3856},
    {267.6, .003 * 85 / 90, 0, .3483, .0230, 1.7471},
    {296.6, .003, 0, .3362, .0380, 1.7721},
    {305.4, .006, 0, .2908, .0600, 1.6692},
    {300.6, .009, 0, .1954, .0910, 1.2876},
    {306.6, .014, 0, .0956, .1390, .8130},
    {288.3, .021, 0, .0320, .2080, .4652},
    {287.1, .030, 0, .0049, .3230, .2720},
    {278.2, .040, 0, .0093, .5030, .1582},
    {271.0, .048, 0, .0633, .7100, .0782},
    {272.3, .063, 0, .1655, .8620, .0422},
    {263.6, .075, 0, .2904, .9540, .0203},
    {255.0, .085, 0, .4334, .9950, .0087},
    {250.6, .103, 0, .5945, .9950, .0039},
    {253.1, .120, 0, .7621, .9520, .0021},
    {253.5, .120, 0, .9163, .8700, .0017},
    {251.3, .115, 0, 1.0263, .7570, .0011},
    {246.3, .125, 0, 1.0622, .6310, .0008},
    {241.7, .120, 0, 1.0026, .5030, .0003},
    {236.8, .105, 0, .8544, .3810, .0002},
    {232.1, .090, 0, .6424, .2650, .0000},
    {228.2, .079, 0, .4479, .1750, .0000},
    {223.4, .067, 0, .2835, .1070, .0000},
    {219.7, .057, 0, .1649, .0610, .0000},
    {215.3, .048, 0, .0874, .0320, .0000},
    {211.0, .036, 0, .0468, .0170, .0000},
    {207.3, .028, .016, .0227, .0082, .0000},
    {202.4, .023, .024, .0114, .0041, .0000},
    {198.7, .018, .0125, .0058, .0021, .0000},
    {194.3, .014, 1, .0029, .0010, .0000},
    {190.7, .011, .87, .0014, .0005, .0000},
    {186.3, .010, .061, .0007, .0003, .0000},
    {182.6, .009, .001, .0003, .0001, .0000},
};

typedef struct {
    double x, y, z;
} Vector;

typedef struct {
    Vector sun; /* towards it, of length 1 */
    double turbidity, zenith_angle;
    double zenith[3]; /* Y in kcd/m2, x, y */
    double perez[3][5];
} Sky;

static double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static Vector unit(Vector v)
{
    const double length = sqrt(dot(v, v));
    return (Vector){v.x / length, v.y / length, v.z / length};
}

/* a_0 + a_1 s + a_2 s^2 + a_3 s^3 */
static double cubic(double s, double a0, double a1, double a2, double a3)
{
    return a0 + s * (a1 + s * (a2 + s * a3));
}

static Sky sky_of(Vector sun, double turbidity)
{
    static const double perez[3][5][2] = {
        {{.17872, -1.46303},
         {-.35540, .42749},
         {-.02266, 5.32505},
         {.12064, -2.57705},
         {-.06696, .37027}},
        {{-.01925, -.25922},
         {-.06651, .00081},
         {-.00041, .21247},
         {-.06409, -.89887},
         {-.00325, .04517}},
        {{-.01669, -.26078},
         {-.09495, .00921},
         {-.00792, .21023},
         {-.04405, -1.65369},
         {-.01092, .05291}},
    };
    Sky sky = {.sun = unit(sun), .turbidity = turbidity};
    const double t = turbidity, s = sky.zenith_angle = acos(sky.sun.z);
    for (int component = 0; component < 3; component++)
        for (int i = 0; i < 5; i++)
            sky.perez[component][i] = perez[component][i][0] * t + perez[component][i][1];
    sky.zenith[0] = fmax(
        (4.0453 * t - 4.9710) * tan((4. / 9 - t / 120) * (M_PI - 2 * s)) - .2155 * t + 2.4192, 0);
    sky.zenith[1] = t * t * cubic(s, 0, .00208, -.00374, .00165) +
                    t * cubic(s, .00394, -.03202, .06377, -.02902) +
                    cubic(s, .25885, .06052, -.21196, .11693);
    sky.zenith[2] = t * t * cubic(s, 0, .00316, -.00610, .00275) +
                    t * cubic(s, .00515, -.04153, .08970, -.04212) +
                    cubic(s, .26688, .06669, -.26756, .15346);
    return sky;
}

static double perez(const double *p, double cosine, double gamma)
{
    return (1 + p[0] * exp(p[1] / cosine)) *
           (1 + p[2] * exp(p[3] * gamma) + p[4] * cos(gamma) * cos(gamma));
}

/* IEC 61966-2-1 by its primaries and D65; what is below 0 raises all. */
static Vector rgb_of_xyz(double x, double y, double z)
{
    Vector c = {3.2404542 * x - 1.5371385 * y - .4985314 * z,
                -.9692660 * x + 1.8760108 * y + .0415560 * z,
                .0556434 * x - .2040259 * y + 1.0572252 * z};
    const double least = fmin(fmin(c.x, fmin(c.y, c.z)), 0);
    return (Vector){c.x - least, c.y - least, c.z - least};
}

static double mean(Vector c) { return (c.x + c.y + c.z) / 3; }

/* Y, x, y of a direction; the chromaticity's y is at least .001, since what is divided by it has to
 * stay finite. */
static Vector radiance(const Sky *sky, Vector view, double *least_y)
{
    double luminance[3];
    view = unit(view);
    if (view.z < 0)
        return (Vector){0, 0, 0};
    view.z = fmax(view.z, .001);
    view = unit(view);
    const double gamma = acos(fmax(fmin(dot(view, sky->sun), 1), -1));
    for (int component = 0; component < 3; component++)
        luminance[component] = sky->zenith[component] *
                               perez(sky->perez[component], view.z, gamma) /
                               perez(sky->perez[component], 1, sky->zenith_angle);
    const double y = fmax(luminance[2], .001), Y = fmax(luminance[0], 0) * 1000 / 683.002;
    if (least_y)
        *least_y = luminance[2];
    return rgb_of_xyz(Y / y * luminance[1], Y / y * y, Y / y * (1 - luminance[1] - luminance[2]));
}

/* Irradiance of the horizontal plane by all the sky. */
static double sky_irradiance(const Sky *sky)
{
    double sum = 0;
    for (int i = 0; i < RINGS; i++)
        for (int k = 0; k < SECTORS; k++) {
            const double z = (i + .5) / RINGS, r = sqrt(1 - z * z),
                         turn = 2 * M_PI * (k + .5) / SECTORS;
            sum += mean(radiance(sky, (Vector){r * cos(turn), r * sin(turn), z}, NULL)) * z;
        }
    return sum * 2 * M_PI / (RINGS * SECTORS);
}

/* By the sun's disc of 32 minutes of arc, through air of relative mass m, .35 cm of ozone and 2 cm
 * of water. */
static double sun_irradiance(const Sky *sky)
{
    if (sky->sun.z <= 0)
        return 0;
    const double degrees = sky->zenith_angle * 180 / M_PI, radius = 16. / 60 * M_PI / 180;
    const double m = 1 / (sky->sun.z + .15 * pow(93.885 - degrees, -1.253)),
                 beta = .04608 * sky->turbidity - .04586;
    Vector sum = {0, 0, 0};
    for (int i = 0; i < BANDS; i++) {
        const double um = (FIRST_NM + STEP_NM * i) / 1000.;
        const double wet = bands[i].water * 2 * m;
        const double through = exp(-.008735 * pow(um, -4.08) * m) * exp(-beta * pow(um, -1.3) * m) *
                               exp(-bands[i].ozone * .35 * m) *
                               exp(-.2385 * wet / pow(1 + 20.07 * wet, .45));
        const double power = bands[i].sun * 100 * through * STEP_NM;
        sum = (Vector){sum.x + power * bands[i].x, sum.y + power * bands[i].y,
                       sum.z + power * bands[i].z};
    }
    return mean(rgb_of_xyz(sum.x, sum.y, sum.z)) * sky->sun.z * 2 * M_PI * (1 - cos(radius));
}

static Vector seen(const MatcDocument *document, Vector view)
{
    char point[128];
    const char *fault;
    MatcOptions options;
    Vector c = {NAN, NAN, NAN};
    matc_options_init(&options);
    snprintf(point, sizeof point, "x=%.17g y=%.17g z=%.17g", view.x, view.y, view.z);
    char *values = matc_eval(document, 0, point, &options, &fault);
    assert_non_null(values);
    assert_int_equal(sscanf(strstr(values, "emissive "), "emissive %lf %lf %lf", &c.x, &c.y, &c.z),
                     3);
    free(values);
    return c;
}

static MatcDocument *read_sky(Vector sun, double turbidity, double factor)
{
    char text[256];
    MatcOptions options;
    matc_options_init(&options);
    snprintf(text, sizeof text,
             "material: SunSkyLight\nsun: [%g, %g, %g]\nturbidity: %g\nradianceFactor: %g\n", sun.x,
             sun.y, sun.z, turbidity, factor);
    MatcDocument *document = matc_read("sky.yaml", text, strlen(text), &options);
    assert_int_equal(matc_material_count(document), 1);
    return document;
}

static void near(double got, double want, double relative)
{
    if (!(fabs(got - want) <= relative * fabs(want) + 1e-12))
        fail_msg("%.12g, not %.12g", got, want);
}

static const Vector views[] = {
    {0, 0, 1}, {1, 0, 1},  {0, 1, 1},      {-1, .3, .5}, {.2, -1, .1}, {0, 1, .4},    {.3, .9, .3},
    {1, 0, 0}, {0, -1, 0}, {.5, .5, 1e-4}, {3, 4, 12},   {0, 0, -1},   {1, 0, -.001},
};
static const Vector suns[] = {{0, 1, .4}, {0, 0, 1}, {1, 1, 1}, {-1, .2, .1}, {3, 4, .7}};

/* The color of every direction over the zenith's: the model alone, without the scale. */
static void test_shape(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof suns / sizeof *suns; i++)
        for (double turbidity = 2; turbidity <= 14; turbidity += 4) {
            const Sky sky = sky_of(suns[i], turbidity);
            MatcDocument *document = read_sky(suns[i], turbidity, 1);
            const double scale = mean(seen(document, (Vector){0, 0, 1})) /
                                 mean(radiance(&sky, (Vector){0, 0, 1}, NULL));
            for (size_t k = 0; k < sizeof views / sizeof *views; k++) {
                const Vector got = seen(document, views[k]), want = radiance(&sky, views[k], NULL);
                near(got.x, scale * want.x, 1e-7);
                near(got.y, scale * want.y, 1e-7);
                near(got.z, scale * want.z, 1e-7);
            }
            matc_document_free(document);
        }
}

/* 10 over the irradiance by sky and sun, times the factor. Within 1 %, for the fit to the standard
 * observer and for the steps of the product's integral; without the ozone it would be too dark. */
static void test_scale(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof suns / sizeof *suns; i++)
        for (double turbidity = 2; turbidity <= 10; turbidity += 4) {
            const Sky sky = sky_of(suns[i], turbidity);
            MatcDocument *document = read_sky(suns[i], turbidity, 3);
            const double total = sky_irradiance(&sky) + sun_irradiance(&sky);
            near(mean(seen(document, (Vector){0, 0, 1})),
                 3 * 10 / total * mean(radiance(&sky, (Vector){0, 0, 1}, NULL)), .01);
            matc_document_free(document);
        }
}

/* The divisor of a color, y of the chromaticity, has a floor of .001 in the product. Skies of valid
 * documents stay above .23: the floor is for rounding, and changes nothing. */
static void test_least_y(void **state)
{
    (void)state;
    for (double turbidity = 1.7; turbidity <= 30; turbidity += .5)
        for (int degrees = 0; degrees <= 180; degrees += 4) {
            const Sky sky = sky_of(
                (Vector){sin(degrees * M_PI / 180), 0, cos(degrees * M_PI / 180)}, turbidity);
            for (int q = 0; q < 90; q += 6)
                for (int turn = 0; turn <= 180; turn += 30) {
                    double y = 1;
                    const double a = q * M_PI / 180, b = turn * M_PI / 180;
                    const Vector c =
                        radiance(&sky, (Vector){sin(a) * cos(b), sin(a) * sin(b), cos(a)}, &y);
                    if (mean(c) > 0 && y < .23)
                        fail_msg("y is %g at turbidity %g, sun at %d degrees", y, turbidity,
                                 degrees);
                }
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_shape),
        cmocka_unit_test(test_scale),
        cmocka_unit_test(test_least_y),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
