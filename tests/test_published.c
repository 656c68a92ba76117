/* MaterialX's procedural brick, written as formulas, beside its published graph in C; its tiled wood and brass; its noise beside what its shader prints; Standard Surface's edge colour beside OpenPBR's tint. */
#include "slot_values.h"

/* -- MaterialX's procedural brick: its pictures are numbers here, its graph is written once as a formula and once in C. */

static const char brick_text[] =
    "material: StandardSurface\n"
    "specular_roughness: \"= 0.853 / brick_mask * brick_roughness\"\n"
    "base_color:\n"
    "  map: Expression\n"
    "  with: { brick: [0.661876, 0.19088, 0], dirt: [0.56372, 0.56372, 0.56372] }\n"
    "  is: \"shade = 0.083 * variation + brick_gray;\n"
    "    wall = hsvtorgb(rgbtohsv(brick) + [(shade - 0.35) * 0.083, 0, shade * 0.787 * variation]);\n"
    "    clamp(mix([0.263273, 0.263273, 0.263273] * brick_gray, mix(wall, dirt, 0.248 * dirt_mask) * brick_gray, "
    "brick_mask), 0, 1)\"\n"
    "defs:\n  brick_mask: %g\n  brick_roughness: %g\n  brick_gray: %g\n  variation: %g\n  dirt_mask: %g\n";

static void to_hsv(const double rgb[3], double hsv[3])
{
    const double most = fmax(rgb[0], fmax(rgb[1], rgb[2])), least = fmin(rgb[0], fmin(rgb[1], rgb[2])),
                 range = most - least;
    double turn = 0;
    if (range > 0)
        turn = most == rgb[0]   ? (rgb[1] - rgb[2]) / range
               : most == rgb[1] ? 2 + (rgb[2] - rgb[0]) / range
                                : 4 + (rgb[0] - rgb[1]) / range;
    hsv[0] = turn / 6 - floor(turn / 6);
    hsv[1] = most > 0 ? range / most : 0;
    hsv[2] = most;
}

static void to_rgb(const double hsv[3], double rgb[3])
{
    for (int i = 0; i < 3; i++) {
        double x = hsv[0] * 6 + (double[]){5, 3, 1}[i];
        x -= 6 * floor(x / 6);
        rgb[i] = hsv[2] - hsv[2] * hsv[1] * fmax(0, fmin(fmin(x, 4 - x), 1));
    }
}

static void procedural_brick(void **state)
{
    (void)state;
    static const double pictures[][5] = {
        {1, .9, .6, .3, .2}, {.5, .2, .4, .9, .8}, {.05, .01, .2, 0, 1}, {.8, 1, 1, 1, 0}, {.3, .3, .35, .5, .5}};
    for (size_t i = 0; i < sizeof pictures / sizeof *pictures; i++) {
        const double mask = pictures[i][0], gloss = pictures[i][1], gray = pictures[i][2], vary = pictures[i][3],
                     dirt = pictures[i][4];
        const double shade = .083 * vary + gray, brick[3] = {.661876, .19088, 0};
        double hsv[3], wall[3], want[3], rough = .853 / mask * gloss;
        to_hsv(brick, hsv);
        hsv[0] += (shade - .35) * .083;
        hsv[2] += shade * .787 * vary;
        to_rgb(hsv, wall);
        for (int lane = 0; lane < 3; lane++) {
            const double dusty = wall[lane] + (.56372 - wall[lane]) * .248 * dirt, mortar = .263273 * gray;
            want[lane] = fmin(fmax(mortar + (dusty * gray - mortar) * mask, 0), 1);
        }
        char text[2048];
        snprintf(text, sizeof text, brick_text, mask, gloss, gray, vary, dirt);
        char *values = values_at(text, "u=0.3 v=0.6", NULL);
        expect_slot(values, "diffuse", want, 3);
        expect_slot(values, "roughness", &rough, 1);
        free(values);
    }
}

/* -- MaterialX's noise3d, noise2d and fractal3d of four octaves, printed by its GLSL (libraries/stdlib/genglsl/lib/mx_noise.glsl, 1.39: mx_perlin_noise_float of
 * three numbers and of two, mx_fractal_noise_float with 4, 2, .5), compiled as C++ in floats */

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
    static const char text[] = "material: Phong\ndiffuse: { map: Noise, octaves: 1 }\nspecular: { map: Noise, octaves: 1, dimensions: 2 }\n"
                               "emissive: { map: Noise, octaves: 4 }\n";
    const double bound = 2e-6; /* roundings of theirs; at a coordinate of 1000 they are those of its fraction, which is exact here */
    double worst = 0;
    for (size_t i = 0; i < sizeof noises / sizeof *noises; i++) {
        char at[128];
        snprintf(at, sizeof at, "x=%.9g y=%.9g z=%.9g", noises[i].p[0], noises[i].p[1], noises[i].p[2]);
        char *values = values_at(text, at, NULL);
        const double given[] = {noises[i].noise3, noises[i].noise2, noises[i].fractal};
        static const char *const slots[] = {"diffuse", "specular", "emissive"};
        for (int k = 0; k < 3; k++) {
            double lanes[3] = {0};
            assert_int_equal(read_slot(values, slots[k], lanes), 3);
            worst = fmax(worst, fabs(lanes[0] - given[k]));
        }
        free(values);
    }
    print_message("noise: %.1e from MaterialX's at most\n", worst);
    assert_true(worst <= bound);
}

/* -- cellnoise3d and cellnoise2d, worleynoise3d and worleynoise2d of jitter 1, worleynoise3d of jitter 0.6, both of style 1, printed by the same file's
 * mx_cell_noise_float and mx_worley_noise_float, as C in floats */

static const struct {
    double p[3], number[7];
} cells[] = {
    {{0.25, 0.5, 0.75}, {0.61106765, 0.86031276, 0.46679258, 0.44171613, 0.36199087, 0.61106765, 0.11411408}},
    {{1.29999995, 2.70000005, -0.400000006}, {0.17603700, 0.06335137, 0.17960092, 0.18071759, 0.20535420, 0.17603700, 0.06335137}},
    {{-3.125, 4.5, 2.25}, {0.76225436, 0.77878547, 0.63058978, 0.45385224, 0.60879135, 0.08266633, 0.77878547}},
    {{10.1000004, -20.2000008, 30.2999992}, {0.88428938, 0.98979414, 0.49803889, 0.63577634, 0.52535194, 0.24138568, 0.98979414}},
    {{-100.599998, 55.5, 7.69999981}, {0.14473616, 0.24845500, 0.55351102, 0.05000119, 0.38448611, 0.14473616, 0.24845500}},
    {{1000.25, 2000.5, -3000.75}, {0.32301342, 0.50681764, 0.51021338, 0.36345491, 0.44597244, 0.32301342, 0.50681764}},
    {{0.100000001, 0.200000003, 0.300000012}, {0.61106765, 0.86031276, 0.13183208, 0.14328156, 0.27699825, 0.61106765, 0.11411408}},
    {{-0.899999976, -0.800000012, -0.699999988}, {0.98178327, 0.97870499, 0.58935153, 0.29852751, 0.59730870, 0.62888855, 0.97870499}},
    {{5.5, 5.5, 5.5}, {0.11790894, 0.67439216, 0.53471231, 0.38462886, 0.32082742, 0.11790894, 0.67439216}},
    {{-1234.5, 0.125, 99.875}, {0.03535166, 0.80059576, 0.41959646, 0.56279367, 0.40185466, 0.03535166, 0.80059576}},
    {{16.8999996, 33.0999985, -64.5}, {0.47191083, 0.37785649, 0.54503810, 0.57252795, 0.43771523, 0.47191083, 0.45214090}},
    {{2.00999999, 3.99000001, 6.5}, {0.62078077, 0.27895975, 0.52901870, 0.48010573, 0.49738288, 0.62078077, 0.27895975}},
};

static void cells_are_those_of_materialx(void **state)
{
    (void)state;
    static const char text[] = "material: Phong\ndiffuse: { map: CellNoise }\nspecular: { map: CellNoise, dimensions: 2 }\nemissive: { map: Worley }\nambient: { map: Worley, "
                               "dimensions: 2 }\ndiffuseTransparency: { map: Worley, jitter: 0.6 }\ntransparency: { map: Worley, style: 1 }\n";
    static const char *const slots[] = {"diffuse", "specular", "emissive", "ambient", "diffuseTransparency", "transparency"};
    double worst = 0;
    for (size_t i = 0; i < sizeof cells / sizeof *cells; i++) {
        char at[128], *values, *other;
        double lanes[3] = {0};
        snprintf(at, sizeof at, "x=%.9g y=%.9g z=%.9g", cells[i].p[0], cells[i].p[1], cells[i].p[2]);
        values = values_at(text, at, NULL);
        other = values_at("material: Phong\ndiffuse: { map: Worley, style: 1, dimensions: 2 }\n", at, NULL);
        for (int k = 0; k < 7; k++) {
            assert_int_equal(read_slot(k < 6 ? values : other, slots[k < 6 ? k : 0], lanes), 3);
            worst = fmax(worst, fabs(lanes[0] - cells[i].number[k]));
        }
        free(values), free(other);
    }
    print_message("cells: %.1e from MaterialX's at most\n", worst);
    assert_true(worst <= 2e-6);
}

/* Its marble (standard_surface_marble_solid.mtlx), whose graph over its own noise printed these colours. */
static void marble(void **state)
{
    (void)state;
    static const struct {
        double p[3], color[3];
    } rows[] = {
        {{0.25, 0.5, 0.75}, {0.553611, 0.553611, 0.624008}},
        {{-0.600000024, 0.300000012, 0.75}, {0.259822, 0.259822, 0.414159}},
        {{0.800000012, -0.100000001, -0.550000012}, {0.156576, 0.156576, 0.340412}},
        {{0.0500000007, 0.899999976, -0.400000006}, {0.793114, 0.793114, 0.795081}},
    };
    static const char text[] = "material: StandardSurface\nbase: 1\nspecular_roughness: 0.1\nbase_color:\n  map: Expression\n"
                               "  is: \"mix([.8, .8, .8], [.1, .1, .3], (sin(6 * (p.x + p.y + p.z) + 3 * veins) / 2 + .5)^3)\"\n"
                               "  with: { veins: { map: Noise, input: { map: XYZTransform, transform: { scale: 4 } } } }\n";
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char at[128];
        snprintf(at, sizeof at, "x=%.9g y=%.9g z=%.9g", rows[i].p[0], rows[i].p[1], rows[i].p[2]);
        char *values = values_at(text, at, NULL);
        expect_slot(values, "diffuse", rows[i].color, 3);
        expect_slot(values, "roughness", &(double){.1}, 1);
        free(values);
    }
}

/* Its tiled wood and its tiled brass (standard_surface_wood_tiled.mtlx, standard_surface_brass_tiled.mtlx), over a picture whose texels are known: tiles.py
 * made them. Each repeats its picture, and reads it as sRGB for its colour and its roughness. */
static const struct {
    int x, y; /* of the picture, from its left and its top */
    double texel[3];
} texels[] = {{10, 12, {30, 74, 92}}, {40, 20, {209, 195, 161}}, {20, 50, {210, 196, 162}}, {50, 50, {174, 52, 18}}, {32, 1, {9, 8, 7}}};

static double linear_of(double byte)
{
    const double c = byte / 255;
    return c <= .04045 ? c / 12.92 : pow((c + .055) / 1.055, 2.4);
}

/* The slots where semantics.md 2.4 has the texel `i`, at (x / width, y / height), of the picture's tile (1, 2), of so many by so many. */
static char *values_at_texel(const char *text, int i, int tiles)
{
    char at[64];
    snprintf(at, sizeof at, "u=%.9g v=%.9g", (1 + texels[i].x / 64.) / tiles, (2 + (63 - texels[i].y) / 64.) / tiles);
    return values_at(text, at, NULL);
}

#define PICTURE(more) "{ map: ImageMap, image: " SOURCE_FOLDER "/examples/tiles.png, colorspace: srgb" more " }"

static void tiled_wood(void **state)
{
    (void)state;
    static const char text[] = "material: StandardSurface\nbase: 1\nbase_color: " PICTURE(", input: &four { map: UVTransform, scaleU: 4, scaleV: 4 }") "\n"
                               "specular: .4\nspecular_roughness: " PICTURE(", channel: r, input: *four") "\nspecular_anisotropy: .5\n"
                               "coat: .1\ncoat_roughness: .2\n";
    for (int i = 0; i < (int)(sizeof texels / sizeof *texels); i++) {
        double color[3];
        for (int lane = 0; lane < 3; lane++)
            color[lane] = linear_of(texels[i].texel[lane]);
        /* widths r^2 / sqrt(1 - .9 * .5) and r^2 sqrt(1 - .9 * .5), which in OpenPBR are R^2 sqrt(2 / (1 + s^2)) and s times that */
        const double s = 1 - .9 * .5, rough = sqrt(color[0] * color[0] / sqrt(s) * sqrt((1 + s * s) / 2));
        char *values = values_at_texel(text, i, 4);
        expect_slot(values, "diffuse", color, 3);
        expect_slot(values, "metalness", &(double){0}, 1);
        expect_slot(values, "roughness", &rough, 1);
        expect_slot(values, "coat", &(double){.1}, 1);
        expect_slot(values, "coatRoughness", &(double){.2}, 1);
        free(values);
    }
}

static void tiled_brass(void **state)
{
    (void)state;
    static const char text[] = "material: StandardSurface\nbase: 1\nspecular: 0\nspecular_roughness: &rough " PICTURE(", channel: r") "\nmetalness: 1\n"
                               "coat: 1\ncoat_color: " PICTURE("") "\ncoat_roughness: *rough\n";
    for (int i = 0; i < (int)(sizeof texels / sizeof *texels); i++) {
        double color[3];
        for (int lane = 0; lane < 3; lane++)
            color[lane] = linear_of(texels[i].texel[lane]);
        char *values = values_at_texel(text, i, 1);
        expect_slot(values, "diffuse", (double[]){.8, .8, .8}, 3);
        expect_slot(values, "metalness", &(double){1}, 1);
        expect_slot(values, "roughness", color, 1);
        expect_slot(values, "coat", &(double){1}, 1);
        expect_slot(values, "coatTint", color, 3);
        expect_slot(values, "coatRoughness", color, 1);
        free(values);
    }
}

/* -- Standard Surface's edge colour of metal (Gulbrandsen 2014) beside OpenPBR's tint at 82 degrees */

static double by_index(double cosine, double n, double k2)
{
    const double sine2 = 1 - cosine * cosine, t0 = n * n - k2 - sine2, both = sqrt(t0 * t0 + 4 * k2 * n * n);
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

/* What the reflection of light from all around differs by, of any metal, and of published gold. */
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
    double worst = 0,
           gold = fmax(edge_difference(.944, .998), fmax(edge_difference(.776, .981), edge_difference(.373, .751)));
    for (double r = .3; r < .995; r += .03)
        for (double g = 0; g < 1.01; g += .1)
            worst = fmax(worst, edge_difference(r, g));
    print_message("edge colour: of all light off by %.4f at most, gold by %.4f\n", worst, gold);
    assert_true(gold < .035 && worst < .15); /* translations.def */
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(procedural_brick), cmocka_unit_test(noise_is_that_of_materialx), cmocka_unit_test(cells_are_those_of_materialx), cmocka_unit_test(marble), cmocka_unit_test(tiled_wood), cmocka_unit_test(tiled_brass),
                                       cmocka_unit_test(edge_tint_stands_for_edge_colour)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
