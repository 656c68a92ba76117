/* Documents as text, identical on every machine: numbers with a fraction are never formatted by
 * the locale. */
#include "render_scenes.h"
#include <math.h>
#include <stdint.h>

static const char from_above[] =
    "image: { width: 1920, height: 1080 }\ncamera: { camera: Perspective, position: [0, "
    "0, 60], up: [0, 1, 0], angle: 30 }\n";
static const char from_aside[] =
    "image: { width: 1920, height: 1080 }\ncamera: { camera: Perspective, position: [3, "
    "-9, 5], target: [0, 0, 1], angle: 40 }\n";

/* -- a linear congruential generator */

static double part(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) / 9007199254740992.0;
}

static double between(uint64_t *state, double low, double high)
{
    return low + (high - low) * part(state);
}

/* "[x, y, z]", four digits each. */
static void put_vector(Text *out, const double v[3])
{
    for (int i = 0; i < 3; i++) {
        text_put(out, i ? ", " : "[");
        text_rounded(out, v[i], 4);
    }
    text_char(out, ']');
}

static void put_color(Text *out, uint64_t *state)
{
    const double red = part(state), green = part(state), blue = part(state);
    put_vector(out, (double[3]){red, green, blue});
}

/* -- series */

static void put_checker(Text *out, int number)
{
    uint64_t state = (uint64_t)number + 1;
    text_format(
        out,
        "  m%d: { material: Phong, specular: .3, shininess: .6, diffuse: { map: Checker, color1: ",
        number);
    put_color(out, &state);
    text_put(out, ", color2: ");
    put_color(out, &state);
    text_format(out, ", input: { map: UVTransform, scaleU: %d, scaleV: %d } } }\n", 1 + number % 4,
                1 + number / 4 % 4);
}

void scenes_materials(Text *out, int count)
{
    enum { ACROSS = 50, UP = SCENES_QUADS / ACROSS };
    const double width = 1.12, height = .79;
    text_put(out, from_above);
    text_put(out, "lights: [{ light: Point, position: [10, 10, 20], intensity: 300 }, { light: "
                  "Directional, direction: [-1, 1, "
                  "-3], intensity: .5, shadows: false }]\nmaterials:\n");
    for (int i = 0; i < count; i++)
        put_checker(out, i);
    text_put(out, "objects:\n");
    for (int i = 0; i < SCENES_QUADS; i++) {
        text_format(out,
                    "- { object: Parallelogram, u: [1.1, 0, 0], v: [0, .78, 0], material: m%d, "
                    "transform: { translation: ",
                    i % count);
        put_vector(
            out, (double[3]){width * (i % ACROSS - ACROSS / 2), height * (i / ACROSS - UP / 2), 0});
        text_put(out, " } }\n");
    }
}

/* The i-th of 1024 cells in an order whose first 2^k cells are spread evenly: a bit reversal
 * with the bits of column and row interleaved. */
static void cell_of(int i, int cell[2])
{
    cell[0] = cell[1] = 0;
    for (int bit = 0; bit < 10; bit++)
        if (i >> bit & 1)
            cell[bit % 2] |= 16 >> bit / 2;
}

static void put_cell(Text *out, int i, double z)
{
    const double edge = 1.25;
    int cell[2];
    cell_of(i, cell);
    put_vector(out, (double[3]){edge * (cell[0] - 15.5), edge * (cell[1] - 15.5), z});
}

void scenes_lights(Text *out, int count)
{
    const double all = 60;
    text_put(out, "image: { width: 1920, height: 1080 }\ncamera: { camera: Perspective, position: "
                  "[0, -24, 14], target: [0, "
                  "-3, 0], angle: 45 }\n"
                  "materials:\n  floor: { material: Phong, diffuse: [.7, .7, .6], specular: .3, "
                  "shininess: .5 }\n"
                  "  box: { material: Phong, diffuse: [.8, .3, .2], specular: .5, shininess: .7 }\n"
                  "objects:\n- { object: Parallelogram, u: [200, 0, 0], v: [0, 200, 0], material: "
                  "floor, transform: { "
                  "translation: [-100, -100, 0] } }\n");
    for (int i = 0; i < SCENES_MAX_LIGHTS; i++) {
        text_put(out,
                 "- { object: Box, size: [.4, .4, .4], material: box, transform: { translation: ");
        put_cell(out, i, .2);
        text_put(out, " } }\n");
    }
    text_put(out, "lights:\n");
    for (int i = 0; i < count; i++) {
        text_put(out, "- { light: Point, shadows: false, intensity: ");
        text_rounded(out, all / count, 6);
        text_put(out, ", position: ");
        put_cell(out, i, 1.5);
        text_put(out, " }\n");
    }
}

/* A leaf in a ball, at a random position and rotation. */
static void put_leaf(Text *out, uint64_t *state, int number)
{
    static const char *const kinds[] = {
        "Box, size: [.04, .04, .5], material: twig",
        "Parallelogram, u: [.24, 0, 0], v: [0, .12, 0], material: spring",
        "Parallelogram, u: [.24, 0, 0], v: [0, .12, 0], material: summer",
        "Parallelogram, u: [.2, .1, 0], v: [0, .1, 0], material: autumn"};
    const double height = between(state, -1, 1), around = between(state, 0, 6.2831853),
                 radius = 1.8 * cbrt(part(state));
    const double across = radius * sqrt(1 - height * height);
    text_format(out, "- { object: %s, transform: { translation: ", kinds[number % 4]);
    put_vector(out, (double[3]){across * cos(around), across * sin(around), 2 + radius * height});
    text_put(out, ", rotation: ");
    const double turns[3] = {between(state, -3, 3), between(state, -3, 3), between(state, -3, 3)};
    put_vector(out, turns);
    text_put(out, " } }\n");
}

void scenes_objects(Text *out, int count)
{
    uint64_t state = 1;
    text_put(
        out,
        "image: { width: 1920, height: 1080 }\n"
        "camera: { camera: Perspective, position: [0, -9, 2], target: [0, 0, 2], angle: 27 }\n");
    text_put(out,
             "lights: [{ light: Directional, direction: [-1, 1, -2], intensity: .9, shadows: false "
             "}, { light: Ambient, "
             "intensity: .2 }]\nmaterials:\n"
             "  twig: { material: Phong, diffuse: [.3, .2, .1] }\n"
             "  spring: { material: Phong, diffuse: [.4, .7, .1], specular: .2, shininess: .5 }\n"
             "  summer: { material: Phong, diffuse: [.1, .5, .1], specular: .2, shininess: .5 }\n"
             "  autumn: { material: Phong, diffuse: [.8, .4, .1], specular: .1, shininess: .5 }\n"
             "objects:\n");
    for (int i = 0; i < count; i++)
        put_leaf(out, &state, i);
}

/* -- passes */

static void put_panes(Text *out, int count)
{
    for (int i = 0; i < count; i++) {
        text_put(out, "- { object: Parallelogram, u: [4, 0, 0], v: [0, 0, 3], material: glass, "
                      "transform: { translation: ");
        put_vector(out, (double[3]){-2, -2 + .3 * i, 0});
        text_put(out, " } }\n");
    }
}

void scenes_passes(Text *out, int panes)
{
    text_put(out, from_aside);
    text_put(
        out,
        "toneMapping: { toneMapping: ReinhardDevlin }\nsky: { material: RGBA, r: .3, g: .4, b: .6 "
        "}\n"
        "materials:\n  stone: { material: Phong, diffuse: { map: Checker, color1: [.7, .7, .6], "
        "color2: [.5, .5, "
        ".5] } }\n"
        "  paint: { material: Phong, diffuse: [.8, .3, .2], specular: .5, shininess: .7 }\n"
        "  glass: { material: Phong, diffuse: [.05, .1, .1], specular: .3, shininess: .8, "
        "transparency: [.8, .9, "
        ".9] }\n"
        "lights:\n- { light: Spot, position: [-3, -4, 6], direction: [3, 4, -6], intensity: 60 }\n"
        "- { light: Directional, direction: [-1, 1, -2], intensity: .5 }\nobjects:\n"
        "- { object: Plane, material: stone }\n"
        "- { object: Sphere, radius: 1, material: paint, transform: { translation: [0, 0, 1] } }\n"
        "- { object: Box, size: [1, 1, 2], material: paint, transform: { translation: [2, 1, 1] } "
        "}\n"
        "- { object: Cone, radius: .6, height: 2, material: paint, transform: { translation: [-2, "
        "1, 0] } }\n");
    put_panes(out, panes);
}

void scenes_panes(Text *out, int count)
{
    const int stride = 7; /* coprime to 10 and 40 */
    text_put(out, from_above);
    text_put(out, "lights: [{ light: Point, position: [5, 5, 60], intensity: 2000, shadows: false "
                  "}]\nmaterials:\n"
                  "  glass: { material: Phong, diffuse: [.1, .2, .3], specular: .2, shininess: .6, "
                  "transparency: [.9, "
                  ".95, .97] }\n"
                  "objects:\n");
    for (int i = 0; i < count; i++) {
        text_put(out, "- { object: Parallelogram, u: [160, 0, 0], v: [0, 160, 0], material: glass, "
                      "transform: { translation: ");
        put_vector(out, (double[3]){-80, -80, i * stride % count});
        text_put(out, " } }\n");
    }
}

void scenes_lobes(Text *out, const char *material, int count)
{
    text_format(out, "image: { width: 256, height: 256 }\ncamera: { camera: Perspective, position: "
                     "[0, -6, 0], target: [0, 0, 0], angle: 40 }\n"
                     "lights:\n");
    for (int i = 0; i < count; i++) {
        const double turn = 2.4 * i, far = 4 * sqrt((i + .5) / count);
        text_put(out, "- { light: Point, shadows: false, intensity: ");
        text_rounded(out, 60. / count, 6);
        text_put(out, ", position: ");
        put_vector(out, (double[3]){far * cos(turn), -3, far * sin(turn)});
        text_put(out, " }\n");
    }
    text_format(out,
                "objects:\n- { object: Parallelogram, u: [8, 0, 0], v: [0, 0, 8], transform: { "
                "translation: [-4, 0, -4] }, material: { %s } }\n",
                material);
}

void scenes_unseen(Text *out)
{
    text_put(out, "- { object: Sphere, transform: { translation: [0, -90, 0] }, material: { "
                  "material: Principled, fuzz: .6, coat: .8 } }\n");
}
