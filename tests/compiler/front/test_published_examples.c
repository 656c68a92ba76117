/* MaterialX's example materials as documents (tests/published), against their published numbers
 * and graphs, which are reimplemented here in double: base color, metalness, roughness and the
 * normal, within 1e-3, and for most also their other parameters. Only facts are taken from
 * MaterialX (Apache 2.0, resources/Materials/Examples). Left out: materials with closures of
 * their own (hair), with nodes that matc lacks (blackbody, hextiledimage), looks and assembled
 * shader balls, which are no materials, and duplicates with other pictures (antique camera, the
 * other chessmen). */
#include "tests/slot_values.h"
#include "compiler/base/file.h"

#define FOLDER SOURCE_FOLDER "/tests/published/"

/* Texels of the picture that stands for theirs, from its left and its top: tiles.py made them. */
static const struct {
    int x, y;
    double texel[3];
} texels[] = {{10, 12, {30, 74, 92}},
              {40, 20, {209, 195, 161}},
              {20, 50, {210, 196, 162}},
              {50, 50, {174, 52, 18}},
              {32, 1, {9, 8, 7}}};
enum { PLACES = sizeof texels / sizeof *texels };

/* A frame of a surface that lies askew. */
static const double tangent[3] = {.8, 0, -.6}, bitangent[3] = {0, 1, 0},
                    unit_normal[3] = {.6, 0, .8};
static const char frame[] = "dpxdu=.8 dpydu=0 dpzdu=-.6 dpxdv=0 dpydv=1 dpzdv=0 nx=.6 ny=0 nz=.8";

/* Inputs at the point: the texel as numbers and as a color, texture coordinates, MaterialX's noise
 * at 4 p. */
typedef struct {
    double raw[3], color[3], u, v, p[3], noise;
} Place;

typedef struct {
    const char *slot;
    int components;
    double value[3];
} Extra;

typedef struct {
    double base[3], metal, rough;
    double normal[3]; /* along the tangent, the bitangent and the normal; 0: the surface's own */
    Extra extra[2];
} Published;

static double linear_of(double c) { return c <= .04045 ? c / 12.92 : pow((c + .055) / 1.055, 2.4); }
static double mixed(double a, double b, double t) { return a + (b - a) * t; }

static void set(double to[3], const double from[3]) { memcpy(to, from, 3 * sizeof *to); }

static void set_normal(const Place *at, Published *m)
{
    for (int i = 0; i < 3; i++)
        m->normal[i] = 2 * at->raw[i] - 1;
}

/* Widths r^2 / q along the tangent and r^2 q across it, q^2 = 1 - .9 a, as OpenPBR's one number:
 * the fourth root of the mean of their squares. */
static double rough_of_widths(double r, double anisotropy)
{
    const double q = sqrt(1 - .9 * anisotropy), wide = r * r / q, narrow = r * r * q;
    return pow((wide * wide + narrow * narrow) / 2, .25);
}

/* A rough coat spreads what a base sends through it. */
static double rough_below(double r, double coat) { return pow(pow(r, 4) + 2 * pow(coat, 4), .25); }

/* -- the graphs */

static void brushed(const Place *at, Published *m)
{
    (void)at;
    m->rough = rough_of_widths(.25, .65);
}

static void standard_paint(const Place *at, Published *m)
{
    (void)at;
    m->rough = rough_of_widths(.4, .5);
}

static void paint(const Place *at, Published *m)
{
    (void)at;
    m->rough = rough_below(.3, .02);
}

static void pearl(const Place *at, Published *m)
{
    (void)at;
    m->rough = rough_below(.35, .15);
}

static void base_is_color(const Place *at, Published *m) { set(m->base, at->color); }
static void base_is_raw(const Place *at, Published *m) { set(m->base, at->raw); }

static void wood(const Place *at, Published *m)
{
    set(m->base, at->color);
    m->rough = rough_of_widths(at->color[0], .5);
}

static void brass(const Place *at, Published *m)
{
    m->rough = at->color[0];
    set(m->extra[0].value, at->color);
    m->extra[1].value[0] = at->color[0];
}

static void usd_brass(const Place *at, Published *m)
{
    set(m->base, at->color);
    m->rough = at->color[0];
}

static void chess_king(const Place *at, Published *m)
{
    set(m->base, at->color); /* scattered light has the same color */
    m->metal = at->raw[1];
    m->rough = at->raw[2];
    set_normal(at, m);
}

static void boombox(const Place *at, Published *m)
{
    chess_king(at, m);
    m->rough = at->raw[1];
    m->metal = at->raw[2];
    set(m->extra[0].value, at->color);
}

static void usd_normal(const Place *at, Published *m) { set(m->normal, at->raw); }

static void to_hsv(const double rgb[3], double hsv[3])
{
    const double most = fmax(rgb[0], fmax(rgb[1], rgb[2])),
                 range = most - fmin(rgb[0], fmin(rgb[1], rgb[2]));
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

/* Its pictures of a mask and of variation are the red, of roughness and dirt the green, of gray the
 * blue of the one picture here. */
static void bricks(const Place *at, Published *m)
{
    const double mask = at->raw[0], vary = at->raw[0], gloss = at->raw[1], dirt = at->raw[1],
                 gray = at->raw[2], shade = .083 * vary + gray;
    double hsv[3], wall[3];
    to_hsv((const double[3]){.661876, .19088, 0}, hsv);
    hsv[0] += (shade - .35) * .083;
    hsv[2] += shade * .787 * vary;
    to_rgb(hsv, wall);
    for (int i = 0; i < 3; i++)
        m->base[i] = fmin(
            fmax(mixed(.263273 * gray, mixed(wall[i], .56372, .248 * dirt) * gray, mask), 0), 1);
    m->rough = .853 / mask * gloss;
    set_normal(at, m);
}

static void ramp(const Place *at, Published *m)
{
    const double top[3] = {1 - at->u, at->u, 0}, bottom[3] = {at->u, at->u, 1 - at->u};
    for (int i = 0; i < 3; i++)
        m->extra[0].value[i] = mixed(top[i], bottom[i], at->v);
}

static void emission(const Place *at, Published *m)
{
    const double sum = at->p[0] + at->p[1] + at->p[2],
                 vein = pow(sin(10 * sum + 3 * at->noise) * .4 + .5, 3);
    for (int i = 0; i < 3; i++)
        m->extra[0].value[i] = mixed(1, (double[]){.2, 0, 0}[i], vein);
    m->extra[1].value[0] = m->extra[0].value[0]; /* red light, through the coat */
}

/* -- the list */

typedef struct {
    const char *file, *name;
    Published numbers;
    void (*graph)(const Place *at, Published *m); /* what is not a number; NULL: nothing */
    /* how its pictures lie: tiles uv - offset; 0 tiles: there are none */
    double tiles, offset[2];
} Row;

static const Row rows[] = {
#include "tests/published/examples.def"
};

/* -- the test */

static const struct {
    double p[3], noise;
} noises[PLACES] = {
    /* as test_published.c has them */
    {{.25, .5, .75}, .20869569},
    {{1.29999995, 2.70000005, -.400000006}, .36789167},
    {{-3.125, 4.5, 2.25}, -.51931888},
    {{10.1000004, -20.2000008, 30.2999992}, -.04642492},
    {{.100000001, .200000003, .300000012}, -.23716526},
};

/* The place `i` where a picture that lies so is read at the texel `i`, which semantics.md 2.4 has
 * at (x / width, y / height), of its tile (1, 2). */
static Place place_of(const Row *row, int i)
{
    Place at = {.noise = noises[i].noise, .u = .1 + .15 * i, .v = .9 - .2 * i};
    for (int component = 0; component < 3; component++) {
        at.raw[component] = texels[i].texel[component] / 255;
        at.color[component] = linear_of(at.raw[component]);
        at.p[component] = noises[i].p[component] / 4;
    }
    if (row->tiles > 0) {
        at.u = (1 + texels[i].x / 64. + row->offset[0]) / row->tiles;
        at.v = (2 + (63 - texels[i].y) / 64. + row->offset[1]) / row->tiles;
    }
    return at;
}

static MatcDocument *document_of(const char *file, const MatcOptions *options)
{
    char path[512];
    size_t size;
    const char *why = NULL;
    snprintf(path, sizeof path, FOLDER "%s.yaml", file);
    char *text = file_read(path, &size, &why);
    assert_non_null(text);
    MatcDocument *document = matc_read(path, text, size, options);
    free(text);
    if (matc_error_count(document))
        fail_msg("%s", matc_diagnostics(document, MATC_TEXT));
    return document;
}

static char *values_of(const MatcDocument *document, const char *name, const Place *at)
{
    char point[512];
    const char *fault = NULL;
    MatcOptions options = quick();
    options.pixels = true;
    const int number = matc_material_find(document, name);
    assert_true(number >= 0);
    snprintf(point, sizeof point, "u=%.12g v=%.12g x=%.9g y=%.9g z=%.9g %s", at->u, at->v, at->p[0],
             at->p[1], at->p[2], frame);
    char *values = matc_eval(document, number, point, &options, &fault);
    assert_non_null(values);
    return values;
}

static void expect_numbers(const char *values, const Published *m)
{
    const double own[3] = {0, 0, 1}, *t = m->normal[2] != 0 ? m->normal : own,
                 length = sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
    double normal[3];
    for (int i = 0; i < 3; i++)
        normal[i] = (t[0] * tangent[i] + t[1] * bitangent[i] + t[2] * unit_normal[i]) / length;
    expect_slot(values, "diffuse", m->base, 3);
    expect_slot(values, "metalness", &m->metal, 1);
    expect_slot(values, "roughness", &m->rough, 1);
    expect_slot(values, "normal", normal, 3);
    for (int i = 0; i < 2 && m->extra[i].slot; i++)
        expect_slot(values, m->extra[i].slot, m->extra[i].value, m->extra[i].components);
}

static void examples_are_what_they_publish(void **state)
{
    (void)state;
    MatcOptions options = quick();
    options.pixels = true;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        MatcDocument *document = document_of(rows[i].file, &options);
        print_message("%s: %s\n", rows[i].file, rows[i].name);
        for (int k = 0; k < PLACES; k++) {
            const Place at = place_of(&rows[i], k);
            Published numbers = rows[i].numbers;
            if (rows[i].graph)
                rows[i].graph(&at, &numbers);
            char *values = values_of(document, rows[i].name, &at);
            expect_numbers(values, &numbers);
            free(values);
        }
        matc_document_free(document);
    }
}

/* The marble's colors, printed by its own graph over its own noise. */
static void marble_is_what_it_prints(void **state)
{
    (void)state;
    static const struct {
        double p[3], color[3];
    } printed[] = {
        {{0.25, 0.5, 0.75}, {0.553611, 0.553611, 0.624008}},
        {{-0.600000024, 0.300000012, 0.75}, {0.259822, 0.259822, 0.414159}},
        {{0.800000012, -0.100000001, -0.550000012}, {0.156576, 0.156576, 0.340412}},
        {{0.0500000007, 0.899999976, -0.400000006}, {0.793114, 0.793114, 0.795081}},
    };
    MatcOptions options = quick();
    MatcDocument *document = document_of("standard_surface", &options);
    for (size_t i = 0; i < sizeof printed / sizeof *printed; i++) {
        Place at = {.u = .3, .v = .6};
        Published numbers = {.rough = .1, .extra = {{"reflectance", 1, {.04}}}};
        set(at.p, printed[i].p);
        set(numbers.base, printed[i].color);
        char *values = values_of(document, "marble_solid", &at);
        expect_numbers(values, &numbers);
        free(values);
    }
    matc_document_free(document);
}

/* No material of the documents is without a row. */
static void all_have_rows(void **state)
{
    (void)state;
    static const char *const files[] = {"standard_surface", "open_pbr", "gltf_pbr", "usd_preview"};
    const MatcOptions options = quick();
    int count = 1; /* the marble */
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        MatcDocument *document = document_of(files[i], &options);
        count -= matc_material_count(document);
        matc_document_free(document);
    }
    assert_int_equal(count + (int)(sizeof rows / sizeof *rows), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(examples_are_what_they_publish),
                                       cmocka_unit_test(marble_is_what_it_prints),
                                       cmocka_unit_test(all_have_rows)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
