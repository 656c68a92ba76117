/* MaterialX's procedural brick, written as formulas, beside its published graph in C; Standard Surface's edge colour beside OpenPBR's tint. */
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
    const struct CMUnitTest tests[] = {cmocka_unit_test(procedural_brick), cmocka_unit_test(edge_tint_stands_for_edge_colour)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
