/* MaterialX's noise and cells against values printed by its shader; Standard Surface's edge
 * color against OpenPBR's tint. */
#include "tests/slot_values.h"

/* -- MaterialX's noise3d, noise2d and fractal3d of four octaves, printed by its GLSL
 * (libraries/stdlib/genglsl/lib/mx_noise.glsl, 1.39: mx_perlin_noise_float of three numbers and of
 * two, mx_fractal_noise_float with 4, 2, .5), compiled as C++ in floats */

static const struct {
    double p[3], noise3, noise2, fractal;
} noises[] = {
    {{0.25, 0.5, 0.75}, 0.20869569, 0.22241777, 0.27007070},
    {{1.29999995, 2.70000005, -0.400000006}, 0.36789167, -0.31387621, 0.31404945},
    {{-3.125, 4.5, 2.25}, -0.51931888, 0.51962847, -0.51931888},
    {{10.1000004, -20.2000008, 30.2999992}, -0.04642492, 0.16975424, -0.08661021},
    {{-100.599998, 55.5, 7.69999981}, 0.32436183, -0.51508743, 0.59122038},
    {{1000.25, 2000.5, -3000.75}, -0.36298868, -0.49054667, -0.24023868},
    {{0.100000001, 0.200000003, 0.300000012}, -0.23716526, 0.20206274, -0.19069403},
    {{-0.899999976, -0.800000012, -0.699999988}, 0.00488579, 0.21488477, -0.01266601},
    {{5.5, 5.5, 5.5}, -0.12275000, 0.00000000, -0.12275000},
    {{-1234.5, 0.125, 99.875}, 0.11438922, -0.45684129, 0.04991063},
    {{16.8999996, 33.0999985, -64.5}, 0.00415242, 0.08537390, 0.21033935},
    {{2.00999999, 3.99000001, 6.5}, -0.25039816, 0.00662836, -0.25057164},
};

static void noise_is_that_of_materialx(void **state)
{
    (void)state;
    static const char text[] = "material: Phong\ndiffuse: { map: Noise, octaves: 1 }\nspecular: { "
                               "map: Noise, octaves: 1, dimensions: 2 }\n"
                               "emissive: { map: Noise, octaves: 4 }\n";
    /* roundings of theirs; at a coordinate of 1000 they are those of its fraction, which is exact
     * here */
    const double bound = 2e-6;
    double worst = 0;
    for (size_t i = 0; i < sizeof noises / sizeof *noises; i++) {
        char at[128];
        snprintf(at, sizeof at, "x=%.9g y=%.9g z=%.9g", noises[i].p[0], noises[i].p[1],
                 noises[i].p[2]);
        char *values = values_at(text, at, NULL);
        const double given[] = {noises[i].noise3, noises[i].noise2, noises[i].fractal};
        static const char *const slots[] = {"diffuse", "specular", "emissive"};
        for (int k = 0; k < 3; k++) {
            double components[3] = {0};
            assert_int_equal(read_slot(values, slots[k], components), 3);
            worst = fmax(worst, fabs(components[0] - given[k]));
        }
        free(values);
    }
    print_message("noise: %.1e from MaterialX's at most\n", worst);
    assert_true(worst <= bound);
}

/* -- cellnoise3d and cellnoise2d, worleynoise3d and worleynoise2d of jitter 1, worleynoise3d of
 * jitter 0.6, both of style 1, printed by the same file's mx_cell_noise_float and
 * mx_worley_noise_float, as C in floats */

static const struct {
    double p[3], number[7];
} cells[] = {
    {{0.25, 0.5, 0.75},
     {0.61106765, 0.86031276, 0.46679258, 0.44171613, 0.36199087, 0.61106765, 0.11411408}},
    {{1.29999995, 2.70000005, -0.400000006},
     {0.17603700, 0.06335137, 0.17960092, 0.18071759, 0.20535420, 0.17603700, 0.06335137}},
    {{-3.125, 4.5, 2.25},
     {0.76225436, 0.77878547, 0.63058978, 0.45385224, 0.60879135, 0.08266633, 0.77878547}},
    {{10.1000004, -20.2000008, 30.2999992},
     {0.88428938, 0.98979414, 0.49803889, 0.63577634, 0.52535194, 0.24138568, 0.98979414}},
    {{-100.599998, 55.5, 7.69999981},
     {0.14473616, 0.24845500, 0.55351102, 0.05000119, 0.38448611, 0.14473616, 0.24845500}},
    {{1000.25, 2000.5, -3000.75},
     {0.32301342, 0.50681764, 0.51021338, 0.36345491, 0.44597244, 0.32301342, 0.50681764}},
    {{0.100000001, 0.200000003, 0.300000012},
     {0.61106765, 0.86031276, 0.13183208, 0.14328156, 0.27699825, 0.61106765, 0.11411408}},
    {{-0.899999976, -0.800000012, -0.699999988},
     {0.98178327, 0.97870499, 0.58935153, 0.29852751, 0.59730870, 0.62888855, 0.97870499}},
    {{5.5, 5.5, 5.5},
     {0.11790894, 0.67439216, 0.53471231, 0.38462886, 0.32082742, 0.11790894, 0.67439216}},
    {{-1234.5, 0.125, 99.875},
     {0.03535166, 0.80059576, 0.41959646, 0.56279367, 0.40185466, 0.03535166, 0.80059576}},
    {{16.8999996, 33.0999985, -64.5},
     {0.47191083, 0.37785649, 0.54503810, 0.57252795, 0.43771523, 0.47191083, 0.45214090}},
    {{2.00999999, 3.99000001, 6.5},
     {0.62078077, 0.27895975, 0.52901870, 0.48010573, 0.49738288, 0.62078077, 0.27895975}},
};

static void cells_are_those_of_materialx(void **state)
{
    (void)state;
    static const char text[] =
        "material: Phong\ndiffuse: { map: CellNoise }\nspecular: { map: CellNoise, dimensions: 2 "
        "}\nemissive: { map: Worley }\nambient: { map: Worley, "
        "dimensions: 2 }\ndiffuseTransparency: { map: Worley, jitter: 0.6 }\ntransparency: { map: "
        "Worley, style: 1 }\n";
    static const char *const slots[] = {
        "diffuse", "specular", "emissive", "ambient", "diffuseTransparency", "transparency"};
    double worst = 0;
    for (size_t i = 0; i < sizeof cells / sizeof *cells; i++) {
        char at[128], *values, *other;
        double components[3] = {0};
        snprintf(at, sizeof at, "x=%.9g y=%.9g z=%.9g", cells[i].p[0], cells[i].p[1],
                 cells[i].p[2]);
        values = values_at(text, at, NULL);
        other = values_at("material: Phong\ndiffuse: { map: Worley, style: 1, dimensions: 2 }\n",
                          at, NULL);
        for (int k = 0; k < 7; k++) {
            assert_int_equal(read_slot(k < 6 ? values : other, slots[k < 6 ? k : 0], components),
                             3);
            worst = fmax(worst, fabs(components[0] - cells[i].number[k]));
        }
        free(values), free(other);
    }
    print_message("cells: %.1e from MaterialX's at most\n", worst);
    assert_true(worst <= 2e-6);
}

/* -- Standard Surface's edge color of metal (Gulbrandsen 2014) beside OpenPBR's tint at 82
 * degrees */

static double by_index(double cosine, double n, double k2)
{
    const double sine2 = 1 - cosine * cosine, t0 = n * n - k2 - sine2,
                 both = sqrt(t0 * t0 + 4 * k2 * n * n);
    const double t1 = both + cosine * cosine, t2 = 2 * cosine * sqrt(fmax(.5 * (both + t0), 0)),
                 across = (t1 - t2) / (t1 + t2);
    const double t3 = cosine * cosine * both + sine2 * sine2, t4 = t2 * sine2;
    return .5 * across * (1 + (t3 - t4) / (t3 + t4));
}

static double by_tint(double cosine, double r, double g)
{
    const double at = (r + (1 - r) * pow(6. / 7, 5)) * (1 - g) / (1. / 7 * pow(6. / 7, 6));
    return r + (1 - r) * pow(1 - cosine, 5) - at * cosine * pow(1 - cosine, 6);
}

/* Greatest difference of the ambient reflection, for any metal, and for published gold. */
static double edge_difference(double r, double g)
{
    enum { STEPS = 2000 };
    const double n = g * (1 - r) / (1 + r) + (1 - g) * (1 + sqrt(r)) / (1 - sqrt(r));
    const double k2 = fmax((r * (n + 1) * (n + 1) - (n - 1) * (n - 1)) / (1 - r), 0);
    double sum = 0;
    for (int i = 0; i < STEPS; i++) {
        const double cosine = (i + .5) / STEPS;
        sum += 2 * cosine * (by_index(cosine, n, k2) - by_tint(cosine, r, g)) / STEPS;
    }
    return fabs(sum);
}

static void edge_tint_stands_for_edge_colour(void **state)
{
    (void)state;
    double worst = 0, gold = fmax(edge_difference(.944, .998),
                                  fmax(edge_difference(.776, .981), edge_difference(.373, .751)));
    for (double r = .3; r < .995; r += .03)
        for (double g = 0; g < 1.01; g += .1)
            worst = fmax(worst, edge_difference(r, g));
    print_message("edge colour: of all light off by %.4f at most, gold by %.4f\n", worst, gold);
    assert_true(gold < .035 && worst < .15); /* translations.def */
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(noise_is_that_of_materialx),
                                       cmocka_unit_test(cells_are_those_of_materialx),
                                       cmocka_unit_test(edge_tint_stands_for_edge_colour)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
