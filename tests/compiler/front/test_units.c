/* Numbers of units.def against an independent list: the usual range of each parameter, its unit,
 * and the unit in which an out-of-range number was probably meant. Every bound is accepted
 * without a warning; the next double outside of it causes one. */
#include "tests/test.h"
#include "compiler/matc.h"
#include "grammar/unit_table.h"
#include "tests/vectors.h"
#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT_CAPACITY = 512, NAME_CAPACITY = 128, MEASURED = 160 /* parameters with a unit */ };

/* Parameters of one unit; `*` stands for every material. */
typedef struct {
    const char *name, *other;
    double low, high, factor;
    const char *params;
} UnitGroup;

static const UnitGroup groups[] = {
    {"", "percent", 0, 1, 0.01,
     " MixMaterial.mask Layer.coat Layer.coatRoughness Layer.coatDarkening"
     " Layer.coatRoughening Principled.baseWeight Principled.diffuseRoughness"
     " Principled.metalness Principled.roughness Principled.anisotropy"
     " Principled.transmission Principled.subsurface Principled.fuzz"
     " Principled.fuzzRoughness Principled.coat Principled.coatRoughness"
     " Principled.coatAnisotropy Principled.coatDarkening Principled.coatRoughening"
     " Principled.film Principled.opacity glTF.metallicFactor glTF.roughnessFactor"
     " glTF.occlusionStrength glTF.alphaCutoff glTF.specularFactor"
     " glTF.clearcoatFactor glTF.clearcoatRoughnessFactor glTF.sheenRoughnessFactor"
     " glTF.transmissionFactor glTF.anisotropyStrength glTF.iridescenceFactor"
     " UsdPreview.metallic UsdPreview.roughness UsdPreview.clearcoat"
     " UsdPreview.clearcoatRoughness UsdPreview.opacity UsdPreview.opacityThreshold"
     " UsdPreview.occlusion StandardSurface.base StandardSurface.diffuse_roughness"
     " StandardSurface.metalness StandardSurface.specular"
     " StandardSurface.specular_roughness StandardSurface.specular_anisotropy"
     " StandardSurface.transmission StandardSurface.subsurface StandardSurface.sheen"
     " StandardSurface.sheen_roughness StandardSurface.coat"
     " StandardSurface.coat_roughness StandardSurface.coat_anisotropy"
     " StandardSurface.coat_affect_color StandardSurface.coat_affect_roughness "},
    {"", "percent", -1, 1, 0.01,
     " Principled.transmissionScatterAnisotropy Principled.subsurfaceAnisotropy"
     " StandardSurface.transmission_scatter_anisotropy"
     " StandardSurface.transmission_extra_roughness"
     " StandardSurface.subsurface_anisotropy "},
    {"ratio", "", -INFINITY, INFINITY, 1,
     " Phong.interior glTF.normalScale glTF.clearcoatNormalScale"
     " StandardSurface.subsurface_scale *.displacementScale "},
    {"", "", 0.4, 5, 1,
     " Layer.coatIor Principled.ior Principled.coatIor Principled.filmIor"
     " glTF.iridescenceIor StandardSurface.coat_IOR StandardSurface.thin_film_IOR "},
    {"", "", 0, 5, 1, " glTF.ior "},
    {"", "", 0.4, 100, 1, " UsdPreview.ior StandardSurface.specular_IOR "},
    {"radians", "degrees", -2 * PI, 2 * PI, PI / 180,
     " UVTransform.angle glTF.anisotropyRotation "},
    {"turns", "degrees", -1, 1, 1. / 360,
     " HSV.hue Principled.anisotropyRotation StandardSurface.specular_rotation"
     " StandardSurface.coat_rotation "},
    {"micrometers", "nanometers", 0, 10, 0.001, " Principled.filmThickness "},
    {"nanometers", "", 0, 10000, 1,
     " StandardSurface.thin_film_thickness glTF.iridescenceThickness "},
    {"world units", "", -INFINITY, INFINITY, 1,
     " Principled.transmissionDepth Principled.subsurfaceRadius glTF.thicknessFactor"
     " glTF.attenuationDistance StandardSurface.transmission_depth"
     " StandardSurface.subsurface_radius *.displacement *.displacementVector"
     " *.displacementBound *.displacementVolume *.displacementThreshold "},
    {"times the scene's light", "", 0, 10000, 1,
     " Principled.emission glTF.emissiveStrength StandardSurface.emission "},
    {"", "", 0, 1, 1, " Phong.shininess Phong.transparencyShininess "},
    {"", "", 5, 100, 1, " Principled.abbe "},
};
enum { GROUPS = sizeof groups / sizeof *groups };

static bool lists(const UnitGroup *group, int param)
{
    const KindRow *kind = &kind_table[param_table[param].kind];
    const bool material = section_of(param_table[param].kind) == SECTION_material;
    char exact[NAME_CAPACITY], any[NAME_CAPACITY];
    snprintf(exact, sizeof exact, " %s.%s ", kind->name, param_table[param].name);
    snprintf(any, sizeof any, " *.%s ", param_table[param].name);
    return strstr(group->params, exact) || (material && strstr(group->params, any));
}

/* The only group that lists the parameter; NULL: none does. */
static const UnitGroup *group_of(int param)
{
    const UnitGroup *found = NULL;
    for (int i = 0; i < GROUPS && param_table[param].kind != KIND_COUNT; i++)
        if (lists(&groups[i], param)) {
            assert_null(found);
            found = &groups[i];
        }
    return found;
}

/* A document in which the parameter has that number. */
static void write_document(char text[TEXT_CAPACITY], const KindRow *kind, const char *param,
                           const char *number)
{
    if (section_of((Kind)(kind - kind_table)) == SECTION_material)
        snprintf(text, TEXT_CAPACITY, "material: %s\n%s: %s\n", kind->name, param, number);
    else if (!strcmp(param, "rotation"))
        snprintf(text, TEXT_CAPACITY,
                 "material: Phong\n"
                 "diffuse: { map: Wood, input: { map: XYZTransform, transform: { rotation: [0, %s, "
                 "0] } } }\n",
                 number);
    else if (!strcmp(kind->name, "HSV"))
        snprintf(text, TEXT_CAPACITY,
                 "material: Phong\ndiffuse: { map: HSV, input: red, %s: %s }\n", param, number);
    else
        snprintf(text, TEXT_CAPACITY,
                 "material: Phong\ndiffuse: { map: Checker, input: { map: %s, %s: %s } }\n",
                 kind->name, param, number);
}

/* How often the number is said to be unusual, and the last such message, of a number printed as it
 * reads back. */
static int count_unusual(const KindRow *kind, const char *param, double number,
                         char message[TEXT_CAPACITY])
{
    char text[TEXT_CAPACITY], digits[NAME_CAPACITY];
    MatcOptions options;
    int count = 0;
    matc_options_init(&options);
    snprintf(digits, sizeof digits, "%.17g", number);
    write_document(text, kind, param, digits);
    MatcDocument *document = matc_read("unit.yaml", text, strlen(text), &options);
    cJSON *list = cJSON_Parse(matc_diagnostics(document, MATC_JSON)), *diagnostic;
    *message = 0;
    cJSON_ArrayForEach(diagnostic, list)
    {
        const char *name = cJSON_GetStringValue(cJSON_GetObjectItem(diagnostic, "kind"));
        if (!name || strcmp(name, "unusual_number") != 0)
            continue;
        snprintf(message, TEXT_CAPACITY, "%s",
                 cJSON_GetStringValue(cJSON_GetObjectItem(diagnostic, "message")));
        count++;
    }
    cJSON_Delete(list);
    matc_document_free(document);
    return count;
}

/* "angle is 7 radians, but is usually from -6.283 to 6.283": borders have three
 * decimals. */
static void assert_message(const char *message, const char *param, const UnitGroup *group,
                           double number)
{
    char begin[TEXT_CAPACITY], end[TEXT_CAPACITY], *rest;
    snprintf(begin, sizeof begin, "%s is ", param);
    assert_int_equal(strncmp(message, begin, strlen(begin)), 0);
    assert_true(strtod(message + strlen(begin), &rest) == number);
    snprintf(end, sizeof end, "%s%s, but is usually from %.10g to %.10g", *group->name ? " " : "",
             group->name, round(group->low * 1000) / 1000, round(group->high * 1000) / 1000);
    assert_string_equal(rest, end);
}

static void assert_borders(const KindRow *kind, const char *param, const UnitGroup *group)
{
    const double ends[] = {group->low, group->high}, beyond[] = {-INFINITY, INFINITY};
    char message[TEXT_CAPACITY];
    for (int end = 0; end < 2; end++) {
        if (count_unusual(kind, param, ends[end], message))
            fail_msg("%s: %s", kind->name, message);
        const double next = nextafter(ends[end], beyond[end]);
        if (count_unusual(kind, param, next, message) != 1)
            fail_msg("%s.%s: no word of %.17g", kind->name, param, next);
        assert_message(message, param, group, next);
    }
}

/* Anything goes: large numbers of both signs, where the parameter takes them. */
static void assert_silent(const KindRow *kind, const char *param)
{
    static const double numbers[] = {-1e5, -1, 0, 1, 1e5};
    char message[TEXT_CAPACITY];
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        if (count_unusual(kind, param, numbers[i], message))
            fail_msg("%s: %s", kind->name, message);
}

static void borders_are_silent_and_what_is_beyond_is_not(void **state)
{
    int measured = 0;
    (void)state;
    for (int i = 0; i < PARAM_COUNT; i++) {
        const UnitRow *unit = unit_of(i);
        const KindRow *kind = &kind_table[param_table[i].kind];
        const char *param = param_table[i].name;
        const UnitGroup *group = group_of(i);
        if (!group != !unit)
            fail_msg("%s.%s: its unit is written in one place only", kind->name, param);
        if (!unit)
            continue;
        measured++;
        assert_string_equal(unit->name, group->name);
        if (isfinite(group->low) && unit != &unit_table[UNIT_gloss])
            assert_borders(kind, param, group);
        else
            assert_silent(kind, param);
    }
    assert_int_equal(measured, MEASURED);
}

/* The angles of a transform are no parameters of a map. */
static void rotations_are_radians(void **state)
{
    const UnitGroup radians = {"radians", "degrees", -2 * PI, 2 * PI, PI / 180, ""};
    (void)state;
    assert_borders(&kind_table[KIND_XYZTransform], "rotation", &radians);
}

typedef struct {
    const char *kind, *param;
    double number;
    const char *hint; /* at the message's end; NULL: none */
} Hint;

/* A number is taken for one of the other unit from twice the upper border on, if it is within the
 * borders then. */
static const Hint hints[] = {
    {"UVTransform", "angle", 90, "; 90 degrees are 1.5708"},
    {"UVTransform", "angle", -45, "; -45 degrees are -0.7854"},
    {"UVTransform", "angle", 12, NULL},
    {"UVTransform", "angle", 13, "; 13 degrees are 0.2269"},
    {"UVTransform", "angle", 360, "; 360 degrees are 6.2832"},
    {"UVTransform", "angle", 361, NULL},
    {"glTF", "anisotropyRotation", 180, "; 180 degrees are 3.1416"},
    {"XYZTransform", "rotation", -90, "; -90 degrees are -1.5708"},
    {"HSV", "hue", 90, "; 90 degrees are 0.25"},
    {"HSV", "hue", -360, "; -360 degrees are -1"},
    {"HSV", "hue", 361, NULL},
    {"Principled", "roughness", 1.99, NULL},
    {"Principled", "roughness", 2, "; 2 percent are 0.02"},
    {"Principled", "roughness", 100, "; 100 percent are 1"},
    {"Principled", "roughness", 101, NULL},
    {"Principled", "roughness", -50, NULL},
    {"Principled", "subsurfaceAnisotropy", -50, "; -50 percent are -0.5"},
    {"Principled", "filmThickness", 550, "; 550 nanometers are 0.55"},
    {"Principled", "filmThickness", 10000, "; 10000 nanometers are 10"},
    {"Principled", "filmThickness", 10001, NULL},
    {"Principled", "ior", 50, NULL},
    {"Principled", "emission", 20000, NULL},
};

static void numbers_of_other_units_are_converted(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof hints / sizeof *hints; i++) {
        const Hint *hint = &hints[i];
        char message[TEXT_CAPACITY];
        int kind = 0;
        while (kind < KIND_COUNT && strcmp(kind_table[kind].name, hint->kind) != 0)
            kind++;
        assert_int_equal(count_unusual(&kind_table[kind], hint->param, hint->number, message), 1);
        const char *reported = strchr(message, ';');
        assert_string_equal(reported ? reported : "", hint->hint ? hint->hint : "");
    }
}

/* The factors, which messages round to four digits. */
static void factors_are_those_of_the_units(void **state)
{
    bool met[GROUPS] = {false};
    (void)state;
    assert_int_equal(GROUPS, UNIT_COUNT);
    for (int i = 0; i < PARAM_COUNT; i++) {
        const UnitRow *unit = unit_of(i);
        const UnitGroup *group = unit ? group_of(i) : NULL;
        if (!group)
            continue;
        assert_string_equal(unit->other, group->other);
        assert_true(fabs(unit->factor - group->factor) <= 1e-15 * group->factor);
        assert_true(unit->low == group->low && unit->high == group->high);
        met[group - groups] = true;
    }
    for (int i = 0; i < GROUPS; i++)
        assert_true(met[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(borders_are_silent_and_what_is_beyond_is_not),
        cmocka_unit_test(rotations_are_radians),
        cmocka_unit_test(numbers_of_other_units_are_converted),
        cmocka_unit_test(factors_are_those_of_the_units)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
