/* --aa of pictures, as drawn: texels and mipmaps are made by the test. */
#include "tests/test.h"
#include "tests/value/apart.h"
#include "tests/draw/mipmaps.h"
#include "tests/draw/sheet.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *const address_names[] = {"repeat", "mirror", "clamp", "border"};
typedef float Pixels[SHEET_PIXELS][4];

static Drawers drawers;
static Mipmaps small, large; /* of 2 x 2 and 8 x 8 texels */

typedef double Want(const Mipmaps *m, double texels, const double u[2], int component);

static char folder[] = "/tmp/matc-filtered-XXXXXX";

static int set_up(void **state)
{
    (void)state;
    const char *fault = drawers_open(&drawers);
    if (fault)
        print_error("%s\n", fault);
    return fault || !mkdtemp(folder) || !mipmaps_write(&small, 2, folder) ||
           !mipmaps_write(&large, 8, folder);
}

static int tear_down(void **state)
{
    (void)state;
    drawers_close(&drawers);
    return remove(small.path) || remove(large.path) || rmdir(folder);
}

/* A picture's value stands at the lower corner of its texel (semantics.md 2.2), its mean over four
 * of them half a texel further. */
static double level_at(const Mipmaps *m, int level, const double u[2], int component)
{
    double scale = 1 << level, x = u[0] * m->side, y = u[1] * m->side;
    return mipmaps_bilinear(m, level, (x + .5) / scale - .5, (y + .5) / scale - .5, component);
}

/* With `texels: centre` each level's texels stand in the middle of their squares, as samplers of
 * OpenGL have them. */
static double middle_at(const Mipmaps *m, int level, const double u[2], int component)
{
    int side = m->side >> level;
    return mipmaps_bilinear(m, level, u[0] * side - .5, u[1] * side - .5, component);
}

typedef double At(const Mipmaps *m, int level, const double u[2], int component);

/* Mixed of two levels, the level being the logarithm of the texels. */
static double between(const Mipmaps *m, At *at, double texels, const double u[2], int component)
{
    double level = fmin(fmax(log2(texels), 0), log2(m->side));
    int low = (int)level, high = m->side >> (low + 1) ? low + 1 : low;
    return at(m, low, u, component) * (1 - level + low) + at(m, high, u, component) * (level - low);
}

/* --aa=box, by imageFiltered.glsl: as it is up to a texel a pixel; between one and two texels mixed
 * with mipmaps; then these alone. */
static double mipmaps_at(const Mipmaps *m, At *at, double texels, const double u[2], int component)
{
    double share = fmin(fmax(texels - 1, 0), 1);
    return at(m, 0, u, component) * (1 - share) + between(m, at, texels, u, component) * share;
}

static double want_mipmaps(const Mipmaps *m, double texels, const double u[2], int component)
{
    return mipmaps_at(m, level_at, texels, u, component);
}

static double want_middle_mipmaps(const Mipmaps *m, double texels, const double u[2], int component)
{
    return mipmaps_at(m, middle_at, texels, u, component);
}

/* The expected value in GLSL 1.10: the mean of sixteen points. */
static double want_samples(const Mipmaps *m, double texels, const double u[2], int component)
{
    double sum = 0, x = u[0] * m->side, y = u[1] * m->side;
    if (texels <= 1)
        return mipmaps_bilinear(m, 0, x, y, component);
    for (int i = 0; i < 16; i++)
        sum += mipmaps_bilinear(m, 0, x + (i % 4 - 1.5) / 4 * texels,
                                y + (i / 4 - 1.5) / 4 * texels, component) /
               16;
    return sum;
}

/* The expected value by the sampler: the mipmap level is the logarithm of the texel count; up to
 * one texel the picture itself. */
static double want_sampler(const Mipmaps *m, double texels, const double u[2], int component)
{
    return between(m, level_at, texels, u, component);
}

static double want_middle_sampler(const Mipmaps *m, double texels, const double u[2], int component)
{
    return between(m, middle_at, texels, u, component);
}

/* A BumpMap's normal: the slope is the difference to one texel further, of the mipmap that is shown
 * here. */
static double want_normal(const Mipmaps *m, double texels, const double u[2], int component)
{
    const double step = .02, texel = 1. / m->side, right[2] = {u[0] + texel, u[1]},
                 up[2] = {u[0], u[1] + texel};
    double here = want_sampler(m, texels, u, 0);
    double n[3] = {-step * m->side * (want_sampler(m, texels, right, 0) - here),
                   -step * m->side * (want_sampler(m, texels, up, 0) - here), 1};
    return n[component] / sqrt(n[0] * n[0] + n[1] * n[1] + 1);
}

/* How much of an interval `wide` around a place lies in 0 to `side`. */
static double part_inside(double place, double wide, double side)
{
    return fmax(fmin(place + wide / 2, side) - fmax(place - wide / 2, 0), 0) / wide;
}

/* The shader's value at a border: the picture with its edge extended, weighted by the pixel's share
 * of the picture; of a texel where the pixel is smaller. */
static double want_part(Want *want, const Mipmaps *m, double texels, const double u[2],
                        int component)
{
    Mipmaps clamped = *m;
    double wide = fmax(texels, 1), part = 1;
    clamped.address = CLAMP;
    for (int axis = 0; axis < 2; axis++)
        part *= part_inside(u[axis] * m->side + .5, wide, m->side);
    return part * want(&clamped, texels, u, component);
}

static double want_part_sampler(const Mipmaps *m, double texels, const double u[2], int component)
{
    return want_part(want_sampler, m, texels, u, component);
}

static double want_part_mipmaps(const Mipmaps *m, double texels, const double u[2], int component)
{
    return want_part(want_mipmaps, m, texels, u, component);
}

/* The expected value in GLSL 1.10 for all address modes except repeat: four points on a rotated
 * grid. */
static double want_points(const Mipmaps *m, double texels, const double u[2], int component)
{
    static const double places[4][2] = {{-.125, -.375}, {.375, -.125}, {-.375, .125}, {.125, .375}};
    double sum = 0;
    for (int i = 0; i < 4; i++)
        sum += mipmaps_bilinear(m, 0, u[0] * m->side + places[i][0] * texels,
                                u[1] * m->side + places[i][1] * texels, component) /
               4;
    return sum;
}

/* A map of a picture, %s in `map`, and what it should show. */
typedef struct {
    const char *map, *slot, *target, *aa;
    Want *want;
    Address address;
    double turns; /* so many, from 0 */
} Look;

/* Greatest error of pixels that cover `texels` texels either way. */
static double measure(const Mipmaps *picture, double texels, const Look *look)
{
    static Pixels rgba;
    char map[1024], image[128];
    double worst = 0;
    ContactSheet sheet;
    Mipmaps addressed = *picture, *m = &addressed;
    m->address = look->address;
    snprintf(image, sizeof image, "map: ImageMap, address: %s, image: %s",
             address_names[look->address], m->path);
    snprintf(map, sizeof map, look->map, image, image);
    Filtered f = {.map = map, .slot = look->slot, .target = look->target, .aa = look->aa};
    if (!filtered_open(&f, &drawers))
        fail_msg("%s", f.error);
    sheet_init(&sheet);
    contact_sheet_set(&sheet, 0, look->turns + (look->turns > 0 ? .25 : .137), texels / m->side, 0);
    contact_sheet_set(&sheet, 1, look->turns - (look->turns > 0 ? .5 : .291), 0, texels / m->side);
    if (!filtered_draw(&f, &sheet, rgba))
        fail_msg("%s", f.error);
    for (int i = 0; i < SHEET_PIXELS * MIPMAPS_COMPONENTS; i++) {
        int pixel = i / MIPMAPS_COMPONENTS, component = i % MIPMAPS_COMPONENTS;
        Surface s;
        sheet_surface(&sheet, pixel, 0, 0, &s);
        const double *at = &s.root[channel_id(GROUP_U, 0)],
                     u[2] = {at[0] - look->turns, at[1] - look->turns};
        double want = look->want(m, texels, u, component);
        note(isnan(rgba[pixel][component]) ? INFINITY : fabs(rgba[pixel][component] - want),
             &worst);
    }
    filtered_close(&f);
    return worst;
}

/* Compares both pictures. */
static int judge(const Look *look, double texels, double most)
{
    int failures = 0;
    for (int k = 0; k < 2; k++) {
        double seen = measure(k ? &large : &small, texels, look);
        print_message("%-7s %-4s %-8s %-6s %d x %d, %g texels a pixel: %.1e, at most %.1e\n",
                      look->target, look->aa, look->slot, address_names[look->address], k ? 8 : 2,
                      k ? 8 : 2, texels, seen, most);
        failures += !(seen <= most);
    }
    return failures;
}

static const char *const targets[] = {"glsl330", "essl300", "glsl110"};

/* Bounds by the driver's mipmaps: bytes, mixed by weights of eight bits. */
static void pictures_show_their_mipmaps(void **state)
{
    (void)state;
    static const struct {
        double texels, most;
    } cases[] = {{.21, 3e-6}, {.9, 3e-6}, {1.5, .01}, {2, .01}, {2.9, .015}, {4, .01}};
    int failures = 0;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int target = 0; target < 3; target++) {
            const Look look = {"{ %s }",
                               "emissive",
                               targets[target],
                               "box",
                               target == 2 ? want_samples : want_mipmaps,
                               REPEAT,
                               0};
            failures += judge(&look, cases[i].texels, target == 2 ? 1e-5 : cases[i].most);
        }
    assert_int_equal(failures, 0);
}

/* Bound of a BumpMap's normal: up to a texel a pixel the texels are mixed in floats, unless mipmaps
 * have none to fetch (GLSL 1.10), or the shader makes the border of a sampler that has none. */
static double most_of_normal(const Look *look, double texels)
{
    const bool sampled = !strcmp(look->target, "glsl110") ||
                         (look->address == BORDER && !strcmp(look->target, "essl300"));
    return texels <= 1 && !sampled ? 1e-6 : .006;
}

/* By default the sampler filters: with the implicit footprint, or with an explicit one for a
 * choice between costly maps. Below a texel its weights have eight bits. */
static void samplers_show_pictures(void **state)
{
    (void)state;
    static const double texels[] = {.21, .9, 1.5, 2, 2.9, 4};
    static const char turbulent[] =
        "{ map: Checker, color1: { %s, input: { map: Turbulence, amount: [0, 0, 0] } }, "
        "color2: { %s, input: { map: Turbulence, amount: [0, 0, 0] } } }";
    int failures = 0;
    for (size_t i = 0; i < sizeof texels / sizeof *texels; i++)
        for (int target = 0; target < 3; target++) {
            const Look looks[] = {
                {"{ %s }", "emissive", targets[target], "auto", want_sampler, REPEAT, 0},
                {turbulent, "emissive", targets[target], "auto", want_sampler, REPEAT, 0},
                {"{ map: BumpMap, displacement: { %s } }", "normal", targets[target], "auto",
                 want_normal, REPEAT, 0}};
            for (size_t k = 0; k < sizeof looks / sizeof *looks; k++)
                failures += judge(&looks[k], texels[i],
                                  k < 2 ? .015 : most_of_normal(&looks[k], texels[i]));
        }
    assert_int_equal(failures, 0);
}

/* Addressing by the sampler of a target, and by the shader if that sampler has no border. */
static void samplers_know_addresses(void **state)
{
    (void)state;
    static const double texels[] = {.21, 1.5, 2, 4};
    int failures = 0;
    for (size_t i = 0; i < sizeof texels / sizeof *texels; i++)
        for (Address address = MIRROR; address < ADDRESS_COUNT; address++)
            for (int target = 0; target < 3; target++) {
                const bool by_shader = address == BORDER && target == 1;
                const Look look = {"{ %s }",
                                   "emissive",
                                   targets[target],
                                   "auto",
                                   by_shader ? want_part_sampler : want_sampler,
                                   address,
                                   0};
                failures += judge(&look, texels[i], .015);
            }
    assert_int_equal(failures, 0);
}

static void means_know_addresses(void **state)
{
    (void)state;
    static const double texels[] = {.21, .9, 1.5, 4};
    int failures = 0;
    for (size_t i = 0; i < sizeof texels / sizeof *texels; i++)
        for (Address address = MIRROR; address < ADDRESS_COUNT; address++)
            for (int target = 0; target < 3; target++) {
                Want *mipmaps = address == BORDER ? want_part_mipmaps : want_mipmaps;
                const Look look = {"{ %s }",
                                   "emissive",
                                   targets[target],
                                   "box",
                                   target == 2 ? want_points : mipmaps,
                                   address,
                                   0};
                failures += judge(&look, texels[i], target == 2 || texels[i] < 1 ? 1e-5 : .015);
            }
    assert_int_equal(failures, 0);
}

/* Pictures of glTF. GLSL 1.10 has no mipmaps by `box`: the test of corners has sixteen places. */
static void texels_stand_in_the_middle(void **state)
{
    (void)state;
    static const double texels[] = {.21, .9, 1.5, 2, 2.9, 4};
    static const char middle[] = "{ %s, texels: centre }";
    int failures = 0;
    for (size_t i = 0; i < sizeof texels / sizeof *texels; i++)
        for (Address address = REPEAT; address <= CLAMP; address++)
            for (int target = 0; target < 2; target++) {
                const Look looks[] = {
                    {middle, "emissive", targets[target], "auto", want_middle_sampler, address, 0},
                    {middle, "emissive", targets[target], "box", want_middle_mipmaps, address, 0}};
                failures += judge(&looks[0], texels[i], .015);
                failures += judge(&looks[1], texels[i], texels[i] < 1 ? 1e-5 : .015);
            }
    assert_int_equal(failures, 0);
}

/* The slope of what goes on for ever is 0; that of a mirrored picture turns round. */
static void slopes_know_addresses(void **state)
{
    (void)state;
    int failures = 0;
    for (Address address = MIRROR; address < ADDRESS_COUNT; address++)
        for (int target = 0; target < 3; target++) {
            const Look look = {"{ map: BumpMap, displacement: { %s } }",
                               "normal",
                               targets[target],
                               "auto",
                               want_normal,
                               address,
                               0};
            failures += judge(&look, .21, most_of_normal(&look, .21));
        }
    assert_int_equal(failures, 0);
}

/* Floats lie 1/4 apart there: a texel of 1/8 is lost beside the coordinate, and so is half of one;
 * pixels are 1/2 apart. */
static void slopes_keep_their_steps_far_out(void **state)
{
    (void)state;
    int failures = 0;
    for (int i = 0; i < 4; i++) {
        const Look look = {.map = "{ map: BumpMap, displacement: { %s } }",
                           .slot = "normal",
                           .target = targets[i % 2],
                           .aa = "auto",
                           .want = want_normal,
                           .address = i & 2 ? MIRROR : REPEAT,
                           .turns = 0x1p21};
        failures += judge(&look, 4, .006);
    }
    assert_int_equal(failures, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_show_their_mipmaps),     cmocka_unit_test(samplers_show_pictures),
        cmocka_unit_test(samplers_know_addresses),         cmocka_unit_test(means_know_addresses),
        cmocka_unit_test(texels_stand_in_the_middle),      cmocka_unit_test(slopes_know_addresses),
        cmocka_unit_test(slopes_keep_their_steps_far_out),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
