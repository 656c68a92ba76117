/* Each slot in each kind of light. Two materials that differ in the slot are drawn, a patch each,
 * and compared with frame/lit_reference.h, summed over the light's directions in double. The slot's
 * effect has to be at least three times the tolerance, so that the comparison proves it; if
 * light_cells.def has no effect, both patches have to be equal within the tolerance. */
/* ctest: unsanitized unoptimized */
#include "tests/test.h"
#include "compiler/evaluate.h"
#include "grammar/scene_tables.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/lit_reference.h"
#include "tests/vectors.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef enum {
    LIGHT_Point,
    LIGHT_Spot,
    LIGHT_Directional,
    LIGHT_Area,
    LIGHT_Sky,
    LIGHT_Ambient,
    LIGHT_Hemisphere,
    LIGHTS
} Light;

/* -- The table --------------------------------------------------------------------------------- */

typedef struct {
    double within;   /* tolerance, as a share of the brighter patch; 0: the cell is missing */
    const char *why; /* reason for no effect; NULL: the slot has an effect */
} Cell;
typedef struct {
    Model model;
    Slot slot;
    const char *common, *base, *changed; /* NULL: nothing is drawn */
    Cell cells[LIGHTS];
} Row;

static const char ambient_alone[] = "Ambient light meets the slot ambient alone";
static const char no_ambient[] = "ambient answers light from nowhere alone";
static const char seen_straight[] =
    "what is straight behind the pixel is seen through it, whatever the lobe";
static const char in_mean[] = "such light meets facets as wide in the mean";
static const char at_grazing[] = "metal is tinted where light grazes its facets";
static const char not_refracted[] = "nothing is refracted; reflections go by the slot reflectance";
static const char mirrored_horizon[] =
    "a Hemisphere is seen along the reflection, whatever the lobe";

#define WITHIN(share)                                                                              \
    {                                                                                              \
        share, NULL                                                                                \
    }
#define NO(share, reason)                                                                          \
    {                                                                                              \
        share, reason                                                                              \
    }
static const Row rows[] = {
#define LIGHT_ROW(model, slot, common, base, changed, ...)                                         \
    {MODEL_##model, SLOT_##slot, common, base, changed, {__VA_ARGS__}},
#define LIGHT_VOID(model, slot, reason)                                                            \
    {MODEL_##model,                                                                                \
     SLOT_##slot,                                                                                  \
     NULL,                                                                                         \
     NULL,                                                                                         \
     NULL,                                                                                         \
     {NO(1, reason), NO(1, reason), NO(1, reason), NO(1, reason), NO(1, reason), NO(1, reason),    \
      NO(1, reason)}},
#include "tests/light_cells.def"
};
enum { ROWS = sizeof rows / sizeof *rows };

/* Lights of each kind on the eye's side, [0], and on the far side, [1], in different colors. Every
 * scene has all kinds, so that one program draws all scenes; kinds that are not under test are
 * DIM. */
#define DIM   1e-9
#define FRONT "color: [1, .8, .6]"
#define BACK  "color: [.5, .7, 1]"
static const struct {
    const char *kind, *text[2];
    double intensity[2];
} columns[LIGHTS] = {
    {"Point", {FRONT ", position: [4, 11, 7]", BACK ", position: [6, 11, -8]"}, {80, 60}},
    {"Spot",
     {FRONT ", position: [4, 11, 7], direction: [0, -.7, -.7], innerAngle: 10, outerAngle: 60",
      BACK ", position: [6, 11, -8], direction: [0, -.7, .7], innerAngle: 10, outerAngle: 60"},
     {160, 120}},
    {"Directional",
     {FRONT ", direction: [.2, -.5, -.8]", BACK ", direction: [-.1, -.6, .7]"},
     {1.2, .9}},
    {"Area",
     {FRONT ", position: [1, 8, 6], u: [0, 4, -3], v: [7, 0, 0]",
      BACK ", position: [2, 8, -6], u: [6, 0, 0], v: [0, 4, 3]"},
     {6, 5}},
    {"Sky", {FRONT, NULL}, {1.5, 0}},
    {"Ambient", {FRONT, NULL}, {1.5, 0}},
    {"Hemisphere", {FRONT ", ground: [.2, .3, .5]", NULL}, {1.5, 0}},
};
static const char sky_text[] =
    "sky: { material: Phong, diffuse: 0, emissive: '= [.6 + .35 * z, .5 - .2 * z + .2 * y, .4 + "
    ".25 * x] + 2 * exp(6 * (.3 * x + .5 * y + .8 * z - 1))' }\n";
static const double front[3] = {1, .8, .6}, back[3] = {.5, .7, 1};

static void sky_light(const double way[3], double rgb[3])
{
    const double glow = 2 * exp(6 * (.3 * way[0] + .5 * way[1] + .8 * way[2] - 1));
    rgb[0] = glow + .6 + .35 * way[2];
    rgb[1] = glow + .5 - .2 * way[2] + .2 * way[1];
    rgb[2] = glow + .4 + .25 * way[0];
}

static void no_cell_is_empty(void **state)
{
    (void)state;
    for (int kind = 0; kind < SCENE_KIND_COUNT; kind++) {
        int found = scene_kind_table[kind].sort != SCENE_SORT_light;
        for (int light = 0; light < LIGHTS; light++)
            found += !strcmp(columns[light].kind, scene_kind_table[kind].name);
        if (!found)
            fail_msg("light_cells.def has no column for %s", scene_kind_table[kind].name);
    }
    for (int row = 0; row < ROWS; row++)
        for (int light = 0; light < LIGHTS; light++)
            if (rows[row].cells[light].within <= 0)
                fail_msg("%s: the cell for %s is empty", slot_table[rows[row].slot].name,
                         columns[light].kind);
}

/* Slots of Phong: those that the layout `integer` stores. Slots of Principled: all others, and
 * those that both models share. */
static void every_slot_has_a_row(void **state)
{
    (void)state;
    static const Slot phong[] = {SLOT_normal,
                                 SLOT_diffuse,
                                 SLOT_alpha,
                                 SLOT_specular,
                                 SLOT_shininess,
                                 SLOT_transparency,
                                 SLOT_transparencyShininess,
                                 SLOT_interpolatedTransparency,
                                 SLOT_diffuseTransparency,
                                 SLOT_ambient,
                                 SLOT_emissive,
                                 SLOT_ior};
    enum { PHONG = sizeof phong / sizeof *phong };
    static const Slot of_phong_alone[] = {SLOT_shininess, SLOT_transparencyShininess,
                                          SLOT_interpolatedTransparency, SLOT_ambient};
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        bool wanted[MODEL_COUNT] = {[MODEL_Phong] = false, [MODEL_Principled] = true};
        for (int i = 0; i < PHONG; i++)
            wanted[MODEL_Phong] |= phong[i] == (Slot)slot;
        for (size_t i = 0; i < sizeof of_phong_alone / sizeof *of_phong_alone; i++)
            wanted[MODEL_Principled] &= of_phong_alone[i] != (Slot)slot;
        for (int model = 0; model < MODEL_COUNT; model++) {
            bool found = !wanted[model];
            for (int row = 0; row < ROWS; row++)
                found |= rows[row].slot == (Slot)slot && rows[row].model == (Model)model;
            if (!found)
                fail_msg("light_cells.def has no row for %s of %s", slot_table[slot].name,
                         model == MODEL_Phong ? "Phong" : "Principled");
        }
    }
}

/* -- The scene --------------------------------------------------------------------------------- */

/* Patches of the plane z = 0, one for each material, row by row, seen orthographically from 53
 * degrees above: 4 x 3.2 pixels each. */
enum {
    COLUMNS = 10,
    PATCHES = 2 * ROWS,
    PATCH = 4,
    DOWN = (PATCHES + COLUMNS - 1) / COLUMNS,
    WIDTH = COLUMNS * PATCH,
    HEIGHT = DOWN * PATCH,
    TEXT = 1 << 17
};
static const double eye[3] = {0, -.6, .8}, up[3] = {0, .8, .6};

typedef struct {
    GlContext *gl;
    MatcOptions options;
    Renderer *renderer;
    MatcLayout *layout;
    char text[TEXT];
    float *rgba;
    LitReference lit[PATCHES];
} Rig;

/* A layout with all slots of both models, which layouts.def does not have: 16 bits a component. */
static void open_layout(Rig *rig)
{
    char text[4096], *to = text;
    to += sprintf(to, "layout: all\ntargets: [RGBA32UI, RGBA32UI, RGBA32UI, RGBA32UI, RGBA32UI, "
                      "RGBA32UI, RGBA32UI, RGBA32UI]\nfields:\n");
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        to += sprintf(to, "- { slot: %s, encoding: %s }\n", slot_table[slot].name,
                      slot == SLOT_normal ? "full" : "half");
    rig->options = frame_exact_options();
    rig->options.layout = NULL;
    rig->layout = matc_layout_read("all.yaml", text, strlen(text), &rig->options);
    if (!matc_layout_ok(rig->layout))
        fail_msg("%s", matc_layout_diagnostics(rig->layout, MATC_TEXT));
    rig->options.custom = rig->layout;
}

/* The pixel that shows a patch's middle, and the point of the plane at that pixel's center. */
static int patch_pixel(int patch, double point[3])
{
    const double middle[2] = {COLUMNS / 2., DOWN / 2.};
    const int x = (patch % COLUMNS) * PATCH + PATCH / 2;
    const double high = (patch / COLUMNS + .5 - middle[1]) * up[1];
    const int y = (int)floor(HEIGHT / 2. + high * PATCH);
    point[0] = middle[0] + (x + .5 - WIDTH / 2.) / PATCH;
    point[1] = middle[1] + (y + .5 - HEIGHT / 2.) / PATCH / up[1];
    point[2] = 0;
    return y * WIDTH + x;
}

static const char *scene_text(Rig *rig, Light light)
{
    char *to = rig->text;
    to += sprintf(to, "image: { width: %d, height: %d }\n", WIDTH, HEIGHT);
    to += sprintf(to,
                  "camera: { camera: Orthographic, position: [%g, %g, 16], target: [%g, %g, 0], "
                  "size: %g, depth: 60 }\n",
                  COLUMNS / 2., DOWN / 2. - 12, COLUMNS / 2., DOWN / 2., fmin(COLUMNS, DOWN));
    to += sprintf(to, "%slights:\n", sky_text);
    for (int i = 0; i < 2 * LIGHTS; i++)
        if (columns[i / 2].text[i % 2])
            to += sprintf(to, "- { light: %s, %s, intensity: %g%s }\n", columns[i / 2].kind,
                          columns[i / 2].text[i % 2],
                          i / 2 == (int)light ? columns[i / 2].intensity[i % 2] : DIM,
                          i / 2 <= LIGHT_Area ? ", shadows: none" : "");
    to += sprintf(to, "objects:\n");
    for (int patch = 0; patch < PATCHES; patch++) {
        const Row *row = &rows[patch / 2];
        if (row->common)
            to += sprintf(to,
                          "- { object: Parallelogram, transform: { translation: [%d, %d, 0] }, "
                          "material: { %s%s%s } }\n",
                          patch % COLUMNS, patch / COLUMNS, row->common, *row->common ? ", " : "",
                          patch % 2 ? row->changed : row->base);
    }
    assert_true(to - rig->text < TEXT);
    return rig->text;
}

/* The oracle's slots at a point of a patch. */
static void patch_slots(const Rig *rig, const SceneMaterial *material, const double point[3],
                        SlotValues *slots)
{
    Surface surface;
    oracle_surface_default(&surface);
    for (int i = 0; i < 2; i++) {
        surface.root[channel_id(GROUP_P, i)] = point[i];
        surface.root[channel_id(GROUP_X, i)] = surface.root[channel_id(GROUP_U, i)] =
            point[i] - floor(point[i]);
    }
    assert_true(evaluate_material(material->document, material->index, &rig->options,
                                  (SurfacePoints){&surface, 1}, slots));
}

/* -- Light in double --------------------------------------------------------------------------- */

/* The lobe for an Area and a Sky: EVEN and BEHIND become Lambertian with their albedo, which is how
 * the renderer treats fuzz and a rough base in these lights (docs/reference/renderer.md). */
static void even_lobe(const LitReference *lit, const double l[3], double parts[LIT_PARTS][3])
{
    double albedos[LIT_PARTS][3];
    const double cosine = dot(lit->normal, l);
    lit_reference_lobe(lit, l, parts);
    lit_reference_albedos(lit, albedos);
    for (int i = 0; i < 3; i++) {
        parts[LIT_EVEN][i] = fmax(cosine, 0) * albedos[LIT_EVEN][i];
        parts[LIT_BEHIND][i] = fmax(-cosine, 0) * albedos[LIT_BEHIND][i];
    }
}

/* Adds light that arrives from one direction; `way` may have any length. */
typedef void LitLobe(const LitReference *lit, const double l[3], double parts[LIT_PARTS][3]);
static void add_lobe(const LitReference *lit, LitLobe *lobe, const double way[3],
                     const double light[3], double sum[3])
{
    double l[3], parts[LIT_PARTS][3];
    for (int i = 0; i < 3; i++)
        l[i] = way[i] / sqrt(dot(way, way));
    lobe(lit, l, parts);
    for (int part = 0; part < LIT_PARTS; part++)
        for (int i = 0; i < 3; i++)
            sum[i] += light[i] * parts[part][i];
}

static void add_point(const LitReference *lit, const double way[3], const double color[3],
                      double intensity, double sum[3])
{
    const double light[3] = {intensity * color[0] / dot(way, way),
                             intensity * color[1] / dot(way, way),
                             intensity * color[2] / dot(way, way)};
    add_lobe(lit, lit_reference_lobe, way, light, sum);
}

/* Smoothstep over the cosine from the outer angle, 60 degrees, to the inner, 10. */
static double cone(const double way[3], const double axis[3])
{
    const double cosine = -dot(way, axis) / sqrt(dot(way, way) * dot(axis, axis));
    const double s = (cosine - cos(PI / 3)) / (cos(PI / 18) - cos(PI / 3));
    return s <= 0 ? 0 : s >= 1 ? 1 : s * s * (3 - 2 * s);
}

/* A parallelogram, sampled at 48 x 48 points; it emits along cross(u, v). */
typedef struct {
    double corner[3], u[3], v[3], intensity;
    const double *color;
} AreaLight;

static void add_area(const LitReference *own, const AreaLight *light, const double point[3],
                     double sum[3])
{
    enum { SIDE = 48 };
    double face[3];
    LitReference mean = *own; /* isotropic, with the mean square width */
    const LitReference *lit = &mean;
    mean.widths[0] = mean.widths[1] = sqrt((pow(own->widths[0], 2) + pow(own->widths[1], 2)) / 2);
    for (int i = 0; i < 3; i++)
        face[i] = light->u[(i + 1) % 3] * light->v[(i + 2) % 3] -
                  light->u[(i + 2) % 3] * light->v[(i + 1) % 3];
    for (int k = 0; k < SIDE * SIDE; k++) {
        double way[3], radiance[3];
        for (int i = 0; i < 3; i++)
            way[i] = light->corner[i] + (k % SIDE + .5) / SIDE * light->u[i] +
                     (k / SIDE + .5) / SIDE * light->v[i] - point[i];
        const double square = dot(way, way),
                     angle = -dot(face, way) / (square * sqrt(square)) / (SIDE * SIDE);
        if (angle <= 0)
            continue;
        for (int i = 0; i < 3; i++)
            radiance[i] = light->intensity * light->color[i] * angle / PI;
        add_lobe(lit, even_lobe, way, radiance, sum);
    }
}

/* Omits Phong's lobe of transmission: add_own() adds the sky that is seen through the surface. */
static void add_sky(const LitReference *lit, double sum[3])
{
    enum { HEIGHTS = 120, TURNS = 120 };
    double parts[LIT_PARTS][3], light[3];
    for (int k = 0; k < HEIGHTS * TURNS; k++) {
        const double z = 2 * (k / TURNS + .5) / HEIGHTS - 1,
                     turn = 2 * PI * (k % TURNS + .5) / TURNS;
        const double way[3] = {sqrt(1 - z * z) * cos(turn), sqrt(1 - z * z) * sin(turn), z};
        even_lobe(lit, way, parts);
        sky_light(way, light);
        for (int part = 0; part < LIT_STRAIGHT; part++)
            for (int i = 0; i < 3; i++)
                sum[i] += 1.5 * front[i] * light[i] * parts[part][i] * 4 / (HEIGHTS * TURNS);
    }
}

/* Phong reflects ambient light by its slot ambient; Principled has no such slot and takes it as
 * uniform light from all directions. */
static void add_ambient(const LitReference *lit, double sum[3])
{
    double parts[LIT_PARTS][3];
    lit_reference_albedos(lit, parts);
    for (int i = 0; i < 3; i++) {
        const double albedo = lit->slots.component[SLOT_model][0] > .5
                                  ? parts[LIT_EVEN][i] + parts[LIT_SPECULAR][i] +
                                        parts[LIT_COAT][i] + parts[LIT_BEHIND][i]
                                  : lit->slots.component[SLOT_ambient][i];
        sum[i] += 1.5 * front[i] * albedo;
    }
}

/* Formulas of scene.def: diffuse and ambient slots by the normal, specular ones by a horizon. */
static double hemisphere_matt(double z, int component)
{
    const double ground[3] = {.2, .3, .5};
    return 1.5 * (ground[component] + (front[component] - ground[component]) * (1 + z) / 2);
}

static double hemisphere_mirrored(double z, int component)
{
    const double ground[3] = {.2, .3, .5}, s = fmin(fmax((z + .3) / .8, 0), 1);
    return 1.5 * (.6 * ground[component] +
                  (front[component] - .6 * ground[component]) * s * s * (3 - 2 * s));
}

static void add_hemisphere(const LitReference *lit, double sum[3])
{
    double parts[LIT_PARTS][3];
    const double z = lit->normal[2], *n = lit->coat_normal,
                 of_coat = 2 * dot(n, eye) * n[2] - eye[2];
    lit_reference_albedos(lit, parts);
    for (int i = 0; i < 3; i++) {
        const double even = parts[LIT_EVEN][i] + lit->slots.component[SLOT_ambient][i];
        sum[i] += even * hemisphere_matt(z, i) + parts[LIT_BEHIND][i] * hemisphere_matt(-z, i);
        sum[i] += parts[LIT_SPECULAR][i] * hemisphere_mirrored(lit->mirrored[2], i);
        sum[i] += parts[LIT_COAT][i] * hemisphere_mirrored(of_coat, i);
    }
}

/* Emission, and the sky behind the pixel times the transmittance. */
static void add_own(const LitReference *lit, double sum[3])
{
    double parts[LIT_PARTS][3], sky[3];
    sky_light((double[]){-eye[0], -eye[1], -eye[2]}, sky);
    lit_reference_albedos(lit, parts);
    lit_reference_emission(lit, sum);
    for (int i = 0; i < 3; i++)
        sum[i] += parts[LIT_STRAIGHT][i] * sky[i];
}

static void expected_light(const LitReference *lit, Light light, const double point[3],
                           double sum[3])
{
    static const AreaLight areas[2] = {{{1, 8, 6}, {0, 4, -3}, {7, 0, 0}, 6, front},
                                       {{2, 8, -6}, {6, 0, 0}, {0, 4, 3}, 5, back}};
    const double ways[2][3] = {{4 - point[0], 11 - point[1], 7}, {6 - point[0], 11 - point[1], -8}};
    add_own(lit, sum);
    switch (light) {
    case LIGHT_Point:
        add_point(lit, ways[0], front, 80, sum);
        add_point(lit, ways[1], back, 60, sum);
        break;
    case LIGHT_Spot:
        add_point(lit, ways[0], front, 160 * cone(ways[0], (const double[]){0, -.7, -.7}), sum);
        add_point(lit, ways[1], back, 120 * cone(ways[1], (const double[]){0, -.7, .7}), sum);
        break;
    case LIGHT_Directional:
        add_lobe(lit, lit_reference_lobe, (const double[]){-.2, .5, .8},
                 (const double[]){1.2 * front[0], 1.2 * front[1], 1.2 * front[2]}, sum);
        add_lobe(lit, lit_reference_lobe, (const double[]){.1, .6, -.7},
                 (const double[]){.9 * back[0], .9 * back[1], .9 * back[2]}, sum);
        break;
    case LIGHT_Area:
        for (int i = 0; i < 2; i++)
            add_area(lit, &areas[i], point, sum);
        break;
    case LIGHT_Sky:
        add_sky(lit, sum);
        break;
    case LIGHT_Ambient:
        add_ambient(lit, sum);
        break;
    default:
        add_hemisphere(lit, sum);
    }
}

/* -- Comparison -------------------------------------------------------------------------------- */

typedef struct {
    double seen[2][3], wanted[2][3];
    double brightest, effect; /* change by the slot at one point, relative to `brightest` */
} Pair;

static Pair pair_of(const Rig *rig, Light light, int row)
{
    Pair pair = {.brightest = 1e-3};
    double point[3], other[3];
    for (int k = 0; k < 2; k++) {
        const int pixel = patch_pixel(2 * row + k, point);
        expected_light(&rig->lit[2 * row + k], light, point, pair.wanted[k]);
        for (int i = 0; i < 3; i++) {
            pair.seen[k][i] = (double)rig->rgba[4 * pixel + i];
            pair.brightest = fmax(pair.brightest, pair.wanted[k][i]);
        }
    }
    expected_light(&rig->lit[2 * row], light, point, other);
    for (int i = 0; i < 3; i++)
        pair.effect = fmax(pair.effect, fabs(pair.wanted[1][i] - other[i]) / pair.brightest);
    return pair;
}

/* Fails an effect of less than three times the tolerance, as the comparison would not prove it. */
static bool check(const Pair *pair, const Cell *cell, const char *where)
{
    const double effect = pair->effect;
    double off = 0;
    for (int i = 0; i < 6; i++)
        off = fmax(off,
                   fabs(pair->seen[i / 3][i % 3] - pair->wanted[i / 3][i % 3]) / pair->brightest);
    const bool fine = cell->why ? effect <= cell->within && off <= cell->within
                                : off <= cell->within && effect >= 3 * cell->within;
    if (!fine || getenv("PRINT_ALL"))
        print_message("%s %s: off by %.4f of %.4f, effect %.3f; seen %.3f %.3f %.3f, %.3f %.3f "
                      "%.3f, wanted %.3f %.3f %.3f, %.3f %.3f %.3f\n",
                      fine ? "    " : "BAD:", where, off, cell->within, effect, pair->seen[0][0],
                      pair->seen[0][1], pair->seen[0][2], pair->seen[1][0], pair->seen[1][1],
                      pair->seen[1][2], pair->wanted[0][0], pair->wanted[0][1], pair->wanted[0][2],
                      pair->wanted[1][0], pair->wanted[1][1], pair->wanted[1][2]);
    return fine;
}

static void slots_are_lit_as_defined(void **state)
{
    Rig *rig = *state;
    int faults = 0;
    for (int light = 0; light < LIGHTS; light++) {
        MatcDocument *document;
        Scene *scene = frame_scene(scene_text(rig, light), &rig->options, &document);
        rig->rgba = frame_floats_by(rig->gl, rig->renderer, scene);
        for (int row = 0; row < ROWS; row++) {
            char where[128];
            if (!rows[row].common)
                continue;
            snprintf(where, sizeof where, "%-11s %-22s %s", columns[light].kind,
                     slot_table[rows[row].slot].name, rows[row].changed);
            const Pair pair = pair_of(rig, light, row);
            faults += !check(&pair, &rows[row].cells[light], where);
        }
        free(rig->rgba);
        frame_forget(scene, document);
    }
    assert_int_equal(faults, 0);
}

/* Evaluates the oracle's slots of all patches, and checks that the two patches of a row differ in
 * the row's slot. */
static void rows_change_their_slot(void **state)
{
    Rig *rig = *state;
    MatcDocument *document;
    Scene *scene = frame_scene(scene_text(rig, LIGHT_Ambient), &rig->options, &document);
    for (int patch = 0, object = 0; patch < PATCHES; patch++) {
        const Row *row = &rows[patch / 2];
        double point[3], apart = 0;
        SlotValues slots;
        if (!row->common)
            continue;
        patch_pixel(patch, point);
        patch_slots(rig, &scene->materials[scene->objects[object++].material], point, &slots);
        lit_reference_open(&slots, eye, &rig->lit[patch]);
        for (int component = 0; component < 4; component++)
            apart += fabs(slots.component[row->slot][component] -
                          rig->lit[patch - patch % 2].slots.component[row->slot][component]);
        if (patch % 2 && apart < .01)
            fail_msg("%s: '%s' does not change it", slot_table[row->slot].name, row->changed);
    }
    frame_forget(scene, document);
}

int main(void)
{
    static Rig rig;
    rig.gl = frame_context();
    open_layout(&rig);
    rig.renderer =
        renderer_open(rig.gl, &(RendererOptions){.compile = &rig.options, .view = "light"});
    const struct CMUnitTest tests[] = {cmocka_unit_test(no_cell_is_empty),
                                       cmocka_unit_test(every_slot_has_a_row),
                                       cmocka_unit_test_prestate(rows_change_their_slot, &rig),
                                       cmocka_unit_test_prestate(slots_are_lit_as_defined, &rig)};
    const int result = cmocka_run_group_tests(tests, NULL, NULL);
    renderer_close(rig.renderer);
    gl_close(rig.gl);
    matc_layout_free(rig.layout);
    return result;
}
