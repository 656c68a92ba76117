/* Every parameter of Principled, away from its default, through every layout, against the layout
 * `integer`: the light is equal within the error of the layout's bits, or a warning names what
 * the layout loses. The oracle determines which slots a parameter changes. */
/* ctest: unsanitized seconds=25 */
#include "tests/test.h"
#include "grammar/tables.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 48, PIXELS = SIDE * SIDE, LONGEST = 1024 };

/* A parameter, and what stands in a document for it to change something. */
typedef struct {
    const char *name, *text;
    bool reported; /* nothing of it is in any layout: a warning names the parameter */
} Row;
static const Row rows[] = {
    {"input", "input: { map: BumpMap, strength: .5, displacement: { map: Leopard } }", false},
    {"baseWeight", "baseWeight: .5", false},
    {"baseColor", "baseColor: [.9, .4, .1]", false},
    {"diffuseRoughness", "diffuseRoughness: 1", false},
    {"metalness", "specular: 1, metalness: 1", false},
    {"specular", "specular: 1", false},
    {"specularColor", "specular: 1, specularColor: [1, .2, .2]", false},
    {"roughness", "specular: 1, roughness: .8", false},
    {"ior", "specular: 1, ior: 2.5", false},
    {"anisotropy", "specular: 1, anisotropy: .8", false},
    {"anisotropyRotation", "specular: 1, anisotropy: .8, anisotropyRotation: .25", false},
    {"transmission", "transmission: .7", false},
    {"transmissionColor", "transmission: .7, transmissionColor: [.9, .2, .2]", false},
    {"transmissionDepth", "transmission: .7, transmissionDepth: 2", true},
    {"transmissionScatter", "transmission: .7, transmissionScatter: .5", true},
    {"transmissionScatterAnisotropy",
     "transmission: .7, transmissionScatter: .5, transmissionScatterAnisotropy: .5", false},
    {"dispersion", "transmission: .7, dispersion: 1", true},
    {"abbe", "transmission: .7, dispersion: 1, abbe: 50", false},
    {"subsurface", "subsurface: .8", false},
    {"subsurfaceColor", "subsurface: .8, subsurfaceColor: [.9, .2, .2]", false},
    {"subsurfaceRadius", "subsurface: .8, subsurfaceRadius: 2", true},
    {"subsurfaceRadiusScale", "subsurface: .8, subsurfaceRadiusScale: 2", true},
    {"subsurfaceAnisotropy", "thinWalled: true, subsurface: .8, subsurfaceAnisotropy: .5", false},
    {"fuzz", "fuzz: .8", false},
    {"fuzzColor", "fuzz: .8, fuzzColor: [.9, .2, .2]", false},
    {"fuzzRoughness", "fuzz: .8, fuzzRoughness: .9", false},
    {"coat", "coat: .8", false},
    {"coatColor", "coat: .8, coatColor: [.9, .2, .2]", false},
    {"coatRoughness", "coat: .8, coatRoughness: .5", false},
    {"coatAnisotropy", "coat: .8, coatAnisotropy: .5", true},
    {"coatIor", "coat: .8, coatIor: 2", false},
    {"coatDarkening", "coat: .8, coatDarkening: 0", false},
    {"coatRoughening", "specular: 1, coat: .8, coatRoughness: .5, coatRoughening: 0", false},
    {"film", "specular: 1, film: 1", false},
    {"filmThickness", "specular: 1, film: 1, filmThickness: .3", false},
    {"filmIor", "specular: 1, film: 1, filmIor: 1.8", false},
    {"emission", "emission: .5", false},
    {"emissionColor", "emission: .5, emissionColor: [.9, .2, .2]", false},
    {"opacity", "opacity: .6", false},
    {"thinWalled", "thinWalled: true, subsurface: .8", false},
    {"tangent", "specular: 1, anisotropy: .8, tangent: [0, 0, 1]", false},
    {"coatNormal", "coat: .8, coatNormal: { map: BumpMap, displacement: { map: Leopard } }", false},
    {"coatTangent", "coat: .8, coatAnisotropy: .5, coatTangent: [0, 0, 1]", true},
};
enum { ROWS = sizeof rows / sizeof *rows };

/* Mean error of light that each layout may have where it loses nothing. */
static const struct {
    const char *name;
    double bound;
} layouts[] = {{"thesis", .006}, {"radix", .006}, {"thin", .009}, {"compact", .042}};
enum { LAYOUTS = sizeof layouts / sizeof *layouts };

typedef struct {
    GlContext *gl;
    MatcOptions options;
} Rig;

/* A material with nothing but what the row says; without a row the one that rows change. Smooth
 * surfaces are white at the horizon by Schlick's formula even without reflectance, which no
 * Phong is. */
static void put_material(char text[LONGEST], const char *parameters)
{
    const bool own = strstr(parameters, "baseColor:"), strong = strstr(parameters, "specular:");
    snprintf(text, LONGEST, "{ material: Principled%s%s%s%s }", own ? "" : ", baseColor: .7",
             strong ? "" : ", specular: 0, roughness: 1", *parameters ? ", " : "", parameters);
}

/* Light from a sphere, by a lamp from one side. */
static float *draw(const Rig *rig, const char *layout, const char *material)
{
    char text[2 * LONGEST];
    MatcDocument *document;
    MatcOptions options = rig->options;
    options.layout = layout;
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\n"
             "camera: { camera: Perspective, position: [0, -40, 0], target: [0, 0, 0], angle: 3 }\n"
             "lights: [{ light: Directional, direction: [.5, .7, -.4], intensity: 3 }]\nobjects: "
             "[{ object: Sphere, material: %s }]\n",
             SIDE, SIDE, material);
    Scene *scene = frame_scene(text, &options, &document);
    float *rgba =
        frame_floats(rig->gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
    frame_forget(scene, document);
    return rgba;
}

/* How far apart pictures are in the mean, over the mean of the second, and the first one's mean
 * over the second's. */
typedef struct {
    double apart, brightness;
} Difference;

static Difference differ(const float *a, const float *b)
{
    double apart = 0, sum_a = 0, sum_b = 0;
    for (int i = 0; i < 4 * PIXELS; i++) {
        if (i % 4 == 3)
            continue;
        apart += fabs((double)a[i] - (double)b[i]);
        sum_a += (double)a[i];
        sum_b += (double)b[i];
    }
    return (Difference){apart / sum_b, sum_a / sum_b};
}

/* All that the compiler says of a material in a layout. From malloc. */
static char *warnings_of(const Rig *rig, const char *layout, const char *material)
{
    char text[2 * LONGEST];
    MatcOptions options = rig->options;
    options.layout = layout;
    snprintf(text, sizeof text, "materials:\n  m: %s\n", material);
    MatcDocument *document = matc_read("m.yaml", text, strlen(text), &options);
    assert_int_equal(matc_material_count(document), 1);
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
    const char *parts[] = {matc_diagnostics(document, MATC_TEXT),
                           matc_program_diagnostics(program, MATC_TEXT)};
    char *all = malloc(strlen(parts[0]) + strlen(parts[1]) + 1);
    assert_non_null(all);
    strcat(strcpy(all, parts[0]), parts[1]);
    matc_program_free(program);
    matc_document_free(document);
    return all;
}

/* The oracle's slots, a line each. From malloc. */
static char *slots_of(const Rig *rig, const char *material)
{
    char text[2 * LONGEST];
    const char *fault = NULL;
    snprintf(text, sizeof text, "materials:\n  m: %s\n", material);
    MatcDocument *document = matc_read("m.yaml", text, strlen(text), &rig->options);
    char *slots = matc_eval(document, 0, "u=.31 v=.42 x=.3 y=.2 z=.4", &rig->options, &fault);
    assert_non_null(slots);
    matc_document_free(document);
    return slots;
}

/* A changed slot that a warning names. Both texts have a line for each slot, in one order. */
static bool names_changed_slot(const char *warnings, const char *slots, const char *plain)
{
    while (*slots && *plain) {
        const size_t line = strcspn(slots, "\n") + 1, other = strcspn(plain, "\n") + 1;
        char name[64];
        snprintf(name, sizeof name, "%.*s", (int)strcspn(slots, " "), slots);
        if ((line != other || strncmp(slots, plain, line) != 0) && strstr(warnings, name))
            return true;
        slots += line;
        plain += other;
    }
    return false;
}

static bool check(const Rig *rig, const Row *row, int layout)
{
    char material[LONGEST], base[LONGEST];
    put_material(material, row->text);
    put_material(base, "");
    char *warnings = warnings_of(rig, layouts[layout].name, material);
    char *slots = slots_of(rig, material), *plain = slots_of(rig, base);
    float *shown = draw(rig, layouts[layout].name, material),
          *truth = draw(rig, "integer", material);
    const Difference off = differ(shown, truth);
    const bool near = off.apart <= layouts[layout].bound,
               named = names_changed_slot(warnings, slots, plain);
    const bool fine = (near || named) && (!row->reported || strstr(warnings, row->name));
    if (!fine || getenv("PRINT_ALL"))
        print_message("%-8s %-30s %s off by %.4f of the mean, %.3f as bright%s%s\n",
                      layouts[layout].name, row->text, fine ? "    " : "BAD:", off.apart,
                      off.brightness, named ? ", named" : "",
                      fine        ? ""
                      : *warnings ? warnings
                                  : " and nothing is said");
    free(warnings);
    free(slots);
    free(plain);
    free(shown);
    free(truth);
    return fine;
}

static void no_parameter_is_lost_silently(void **state)
{
    const Rig *rig = *state;
    int faults = 0;
    for (int i = 0; i < ROWS; i++)
        for (int layout = 0; layout < LAYOUTS; layout++)
            faults += !check(rig, &rows[i], layout);
    assert_int_equal(faults, 0);
}

/* Displacement moves the mesh, which no layout has to do with. */
static void every_parameter_has_a_row(void **state)
{
    (void)state;
    const KindRow *kind = &kind_table[KIND_Principled];
    for (int i = 0; i < kind->count; i++) {
        const char *name = param_table[kind->first + i].name;
        bool found = !strncmp(name, "displacement", 12);
        for (int k = 0; k < ROWS; k++)
            found |= !strcmp(rows[k].name, name);
        if (!found)
            fail_msg("%s has no row", name);
    }
}

/* In a layout without `model` a Principled is lit as the nearest Phong: as bright in the mean,
 * where its lobe is wide. */
static void phongs_are_as_bright(void **state)
{
    const Rig *rig = *state;
    static const struct {
        const char *text;
        double low, high; /* of the mean light, over that of the Principled */
    } cases[] = {{"baseColor: 1, specular: 0", .985, 1.015},
                 {"baseColor: 1, specular: 0, roughness: 1", .998, 1.002},
                 {"baseColor: 1", .98, 1.02},
                 {"baseColor: 1, roughness: .6", .98, 1.02},
                 {"baseColor: 1, roughness: 1", .99, 1.01},
                 {"baseColor: 1, coat: .8", .9, 1.1},
                 {"baseColor: 0, roughness: .5", .9, 1.1},
                 {"baseColor: 1, metalness: 1, roughness: .7", .9, 1.1},
                 {"baseColor: 1, metalness: 1, roughness: 1", .98, 1.02}};
    int faults = 0;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int layout = 0; layout < 3; layout++) {
            char material[LONGEST];
            snprintf(material, sizeof material, "{ material: Principled, %s }", cases[i].text);
            float *shown = draw(rig, layouts[layout].name, material),
                  *truth = draw(rig, "integer", material);
            const Difference off = differ(shown, truth);
            const bool fine = off.brightness >= cases[i].low && off.brightness <= cases[i].high;
            print_message("%-8s %-45s %.3f as bright%s\n", layouts[layout].name, cases[i].text,
                          off.brightness, fine ? "" : ": BAD");
            faults += !fine;
            free(shown);
            free(truth);
        }
    assert_int_equal(faults, 0);
}

int main(void)
{
    Rig rig = {.gl = frame_context(), .options = frame_exact_options()};
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_parameter_has_a_row),
        cmocka_unit_test_prestate(no_parameter_is_lost_silently, &rig),
        cmocka_unit_test_prestate(phongs_are_as_bright, &rig)};
    const int result = cmocka_run_group_tests(tests, NULL, NULL);
    gl_close(rig.gl);
    return result;
}
