/* Translated materials of other models against their publishers' definitions, and against a
 * Principled written by hand from both specifications. Published: MaterialX's example materials
 * (Apache 2.0; facts alone)
 * standard_surface_{gold,copper,chrome,plastic,greysphere,brick_procedural},
 * usd_preview_surface_{gold,plastic}, gltf_pbr_{plastic,carpaint}; the formulas of glTF 2.0,
 * UsdPreviewSurface 2.6. */
#include "tests/slot_values.h"
#include "grammar/translation_tables.h"

static double reflectance_of(double ior) { return (ior - 1) * (ior - 1) / ((ior + 1) * (ior + 1)); }

static void published_values(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double base[3], metal, rough, tint[3], reflectance, emissive[3], opacity;
    } rows[] = {
        {"material: StandardSurface\nbase: 1\nbase_color: [0.944, 0.776, 0.373]\nspecular: "
         "1\nspecular_color: [0.998, "
         "0.981, 0.751]\n"
         "specular_roughness: 0.02\nmetalness: 1\n",
         {.944, .776, .373},
         1,
         .02,
         {.998, .981, .751},
         .04,
         {0},
         1},
        {"material: StandardSurface\nbase: 1\nbase_color: [1, 1, 1]\nspecular: 1\nspecular_color: "
         "[1, 1, "
         "1]\nspecular_roughness: 0\nmetalness: 1\n",
         {1, 1, 1},
         1,
         0,
         {1, 1, 1},
         .04,
         {0},
         1},
        {"material: StandardSurface\nbase: 1\nspecular: 0\nspecular_roughness: 0.25\nmetalness: "
         "1\ncoat: 1\n"
         /* copper: its metal has a black edge */
         "coat_color: [0.96467984, 0.37626296, 0.25818297]\ncoat_roughness: 0.2\n",
         {.8, .8, .8},
         1,
         .25,
         {0, 0, 0},
         .04,
         {0},
         1},
        {"material: standard_surface\nbase: 1\nbase_color: [0.10470402, 0.24188282, "
         "0.81800002]\nspecular_roughness: "
         "0.32467532157897949\n",
         {.104704, .241883, .818},
         0,
         .324675,
         {1, 1, 1},
         .04,
         {0},
         1},
        {"material: StandardSurface\nbase: 1\nbase_color: [0.18, 0.18, 0.18]\ndiffuse_roughness: "
         "0\nspecular: "
         "1\nspecular_color: [1, 1, 1]\n"
         "specular_roughness: 0.7\nspecular_IOR: 1.5\n",
         {.18, .18, .18},
         0,
         .7,
         {1, 1, 1},
         .04,
         {0},
         1},
        {"material: StandardSurface\nbase: 0.5\nbase_color: [0.1037792, 0.59212029, "
         "0.85064936]\nspecular_roughness: "
         "0.4\n"
         /* car paint; as wide as .16 / q and .16 q, q^2 = .55 */
         "specular_anisotropy: 0.5\ntransmission_depth: 1\ncoat: 1\ncoat_roughness: 0\n",
         {.0518896, .296060, .425325},
         0,
         .41725952,
         {1, 1, 1},
         .04,
         {0},
         1},
        {"material: StandardSurface\n", {.8, .8, .8}, 0, .2, {1, 1, 1}, .04, {0}, 1},
        {"material: StandardSurface\nopacity: [0.25, 0.5, 0.75]\nemission: 2\nemission_color: [1, "
         "0.5, "
         "0.25]\nspecular: 0.5\nspecular_color: [0, 1, 0]\n"
         "specular_IOR: 2\n",
         {.8, .8, .8},
         0,
         .2,
         {0, 1, 0},
         .5 / 9,
         {1, .5, .25},
         .5},
        {"material: UsdPreviewSurface\ndiffuseColor: [0.944, 0.776, 0.373]\nuseSpecularWorkflow: "
         "false\nmetallic: "
         "1\nroughness: 0.02\nior: 50\n",
         {.944, .776, .373},
         1,
         .02,
         {1, 1, 1},
         49 * 49 / (51. * 51),
         {0},
         1},
        {"material: UsdPreview\ndiffuseColor: [0.10470402, 0.24188282, 0.81800002]\nroughness: "
         "0.32467532157897949\nclearcoat: 0\n"
         "clearcoatRoughness: 0.01\nior: 1.5\n",
         {.104704, .241883, .818},
         0,
         .324675,
         {1, 1, 1},
         .04,
         {0},
         1},
        {"material: UsdPreview\n", {.18, .18, .18}, 0, .5, {1, 1, 1}, .04, {0}, 1},
        {"material: UsdPreview\nuseSpecularWorkflow: true\nspecularColor: [0.5, 0.25, "
         "0.125]\nmetallic: "
         "1\nemissiveColor: [3, 2, 1]\n",
         {.18, .18, .18},
         0,
         .5,
         {1, .5, .25},
         .5,
         {3, 2, 1},
         1},
        {"material: UsdPreview\nuseSpecularWorkflow: true\n",
         {.18, .18, .18},
         0,
         .5,
         {0, 0, 0},
         0,
         {0},
         1},
        {"material: UsdPreview\nopacity: 0.4\nopacityThreshold: 0.5\n",
         {.18, .18, .18},
         0,
         .5,
         {1, 1, 1},
         .04,
         {0},
         0},
        {"material: UsdPreview\nopacity: 0.4\nopacityThreshold: 0.4\n",
         {.18, .18, .18},
         0,
         .5,
         {1, 1, 1},
         .04,
         {0},
         1},
        {"material: UsdPreview\nopacity: 0.4\nopacityMode: presence\n",
         {.18, .18, .18},
         0,
         .5,
         {1, 1, 1},
         .04,
         {0},
         .4},
        {"material: gltf_pbr\nbaseColorFactor: [0.104704, 0.241883, 0.818]\nmetallicFactor: "
         "0\nroughnessFactor: "
         "0.324675\n",
         {.104704, .241883, .818},
         0,
         .324675,
         {1, 1, 1},
         .04,
         {0},
         1},
        {"material: glTF\nbaseColorFactor: [0.0518895, 0.29606, 0.425324]\nmetallicFactor: "
         "0\nroughnessFactor: "
         "0.4\nclearcoatFactor: 1\n",
         {.0518895, .29606, .425324},
         0,
         .4,
         {1, 1, 1},
         .04,
         {0},
         1},
        {"material: glTF\n", {1, 1, 1}, 1, 1, {1, 1, 1}, .04, {0}, 1},
        {"material: glTF\nbaseColorFactor: [0.5, 1, 1, 0.5]\nbaseColorTexture: [0.5, 0.25, 1, "
         "0.8]\nmetallicRoughnessTexture: [0.9, 0.5, 0.25]\n"
         "roughnessFactor: 0.5\nemissiveFactor: [1, 0.5, 0]\nemissiveTexture: [0.5, 0.5, "
         "0.5]\nemissiveStrength: "
         "8\nalphaMode: BLEND\n",
         {.25, .25, 1},
         .25,
         .25,
         {1, 1, 1},
         .04,
         {4 * .4, 2 * .4, 0},
         .4},
        {"material: glTF\nbaseColorFactor: [1, 1, 1, 0.5]\nalphaMode: MASK\n",
         {1, 1, 1},
         1,
         1,
         {1, 1, 1},
         .04,
         {0},
         1},
        {"material: glTF\nbaseColorFactor: [1, 1, 1, 0.5]\nalphaMode: MASK\nalphaCutoff: 0.51\n",
         {1, 1, 1},
         1,
         1,
         {1, 1, 1},
         .04,
         {0},
         0},
        {"material: glTF\nbaseColorFactor: [1, 1, 1, 0.5]\n",
         {1, 1, 1},
         1,
         1,
         {1, 1, 1},
         .04,
         {0},
         1},
        {"material: glTF\nmetallicFactor: 0\nior: 2\nspecularFactor: 0.5\nspecularTexture: [0, 0, "
         "0, "
         "0.5]\nspecularColorFactor: [0.5, 1, 1]\n",
         {1, 1, 1},
         0,
         1,
         {.5, 1, 1},
         .25 / 9,
         {0},
         1},
    };
    assert_true(fabs(reflectance_of(1.5) - .04) < 1e-12 &&
                fabs(reflectance_of(2) - 1. / 9) < 1e-12);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char *values = values_at(rows[i].text, "", NULL);
        const double clear = 1 - rows[i].opacity, through[3] = {clear, clear, clear},
                     model = MODEL_Principled;
        expect_slot(values, "diffuse", rows[i].base, 3);
        expect_slot(values, "metalness", &rows[i].metal, 1);
        expect_slot(values, "roughness", &rows[i].rough, 1);
        expect_slot(values, "specular", rows[i].tint, 3);
        expect_slot(values, "reflectance", &rows[i].reflectance, 1);
        expect_slot(values, "emissive", rows[i].emissive, 3);
        expect_slot(values, "transparency", through, 3);
        expect_slot(values, "model", &model, 1);
        free(values);
    }
}

/* Both widths are kept: of glTF .25 + .75 * .36 = .52 and .25, of Standard Surface .25 / q and .25
 * q, q^2 = 1 - .9 * .6; and where they point. */
static void widths_are_kept(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double wide, narrow, turn;
    } rows[] = {
        {"material: glTF\nroughnessFactor: 0.5\nanisotropyStrength: 0.6\nanisotropyRotation: 0.4\n",
         .52, .25, .4},
        {"material: glTF\nroughnessFactor: 0.5\nanisotropyStrength: { param: strength, default: "
         "0.6 }\n",
         .52, .25, 0},
        {"material: StandardSurface\nspecular_roughness: 0.5\nspecular_anisotropy: "
         "0.6\nspecular_rotation: 0.1\n",
         .3686049, .1695582, .62831853},
        {"material: Principled\nroughness: 0.5\nanisotropy: 0.5\nanisotropyRotation: { map: "
         "Checker, color1: 0.3, color2: 0.3 }\n",
         .3162278, .1581139, 1.8849556},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char *values = values_at(rows[i].text, "", NULL);
        const double wide = rows[i].wide, narrow = rows[i].narrow, strength = 1 - narrow / wide;
        const double rough = pow((wide * wide + narrow * narrow) / 2, .25),
                     slot[] = {strength * cos(2 * rows[i].turn), strength * sin(2 * rows[i].turn)};
        expect_slot(values, "roughness", &rough, 1);
        expect_slot(values, "anisotropy", slot, 2);
        free(values);
    }
}

/* glTF's walls are thin where its volume has no thickness: light has the color once, and through a
 * body at each of two surfaces its root. */
static void thick_glass_is_no_thin_wall(void **state)
{
    (void)state;
    static const char *const texts[] = {"", "thicknessFactor: 1\n"};
    static const double through[][3] = {{.25, .25, .25}, {.5, .5, .5}},
                        reflected[] = {2 * .04 / 1.04, .04};
    for (int i = 0; i < 2; i++) {
        char text[256];
        snprintf(text, sizeof text,
                 "material: glTF\nmetallicFactor: 0\nbaseColorFactor: [0.25, 0.25, "
                 "0.25]\ntransmissionFactor: 1\n%s",
                 texts[i]);
        char *values = values_at(text, "", NULL);
        expect_slot(values, "transparency", through[i], 3);
        expect_slot(values, "reflectance", &reflected[i], 1);
        free(values);
    }
}

/* Numbers alone become what the same Principled compiles to, operation by operation; so do maps. */
static void same_programs(void **state)
{
    (void)state;
    const MatcOptions options = quick();
    static const char *const pairs[][2] = {
        {"material: StandardSurface\nbase_color: [0.9, 0.6, 0.2]\nmetalness: "
         "1\nspecular_roughness: { map: Leopard "
         "}\nnormal: { map: NormalMap, normal: { map: Checker } }\n",
         "material: Principled\nbaseColor: [0.9, 0.6, 0.2]\nmetalness: 1\nroughness: { map: "
         "Leopard }\ninput: { map: "
         "NormalMap, normal: { map: Checker } }\n"},
        {"material: glTF\nmetallicFactor: 0\nroughnessFactor: 0.5\nnormalTexture: { map: Checker "
         "}\nnormalScale: "
         "0.5\ninput: { map: WaveMap }\n",
         "material: Principled\nbaseColor: 1\nroughness: 0.5\ninput: { map: NormalMap, scale: 0.5, "
         "normal: { map: "
         "Checker }, input: { map: WaveMap } }\n"},
        {"material: UsdPreview\ndiffuseColor: { map: Checker }\nroughness: { param: rough, "
         "default: 0.5 "
         "}\ndisplacement: { map: Leopard }\ndisplacementScale: 0.1\n",
         "material: Principled\nbaseColor: { map: Checker }\nroughness: { param: rough, default: "
         "0.5 }\ndisplacement: "
         "{ map: Leopard }\ndisplacementScale: 0.1\n"},
        {"material: glTF\nmetallicRoughnessTexture: { map: Checker, color1: \"#ff8040\", color2: "
         "0.25 }\n",
         "material: Principled\nbaseColor: 1\nmetalness: { map: Separate, channel: b, input: "
         "&checker { map: Checker, "
         "color1: \"#ff8040\", color2: 0.25 } }\n"
         "roughness: { map: Separate, channel: g, input: *checker }\n"},
    };
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        char *ours = compile_text(pairs[i][0], MATC_IR, &options),
             *hand = compile_text(pairs[i][1], MATC_IR, &options);
        assert_string_equal(ours, hand);
        free(ours);
        free(hand);
    }
}

/* A Phong beside a Principled: n = 30 and (.8, .4, .4) reflect .05 of the light along the normal,
 * as wide as a roughness of .5. */
static void a_phong_becomes_a_principled(void **state)
{
    (void)state;
    static const char *const wholes[] = {
        "material: Mix\nmask: 0\na: %s\nb: { material: Principled }\n",
        "material: Mix\nmask: 1\nb: { material: SideSwitch, frontShader: %s }\na: { material: "
        "Principled }\n",
        "material: SideSwitch\nfrontShader: %s\nbackShader: { material: Principled }\n"};
    static const double tint[] = {1, .5, .5}, reflectance = .05, rough = .5, metal = 0,
                        model = MODEL_Principled, shininess = 4;
    for (size_t i = 0; i < sizeof wholes / sizeof *wholes; i++) {
        char text[512], *reported;
        snprintf(text, sizeof text, wholes[i],
                 "{ material: Phong, specular: [0.8, 0.4, 0.4], shininess: 0.746045, ambient: 1 }");
        char *values = values_at(text, "", &reported);
        expect_slot(values, "specular", tint, 3);
        expect_slot(values, "reflectance", &reflectance, 1);
        expect_slot(values, "roughness", &rough, 1);
        expect_slot(values, "metalness", &metal, 1);
        expect_slot(values, "model", &model, 1);
        expect_slot(values, "ambient", (double[]){0, 0, 0}, 3);
        expect_slot(values, "shininess", &shininess, 1);
        assert_non_null(strstr(reported, "[-Wmixed_models]"));
        free(values);
        free(reported);
    }
    char *reported;
    free(values_at("material: AlgorithmSwitch\nguiShader: { material: Phong }\nraytracerShader: { "
                   "material: Principled }\n",
                   "", &reported));
    assert_string_equal(reported, "");
    free(reported);
}

/* Layouts that cannot tell a Principled from a Phong. */
static void layouts_without_the_model_are_doubted(void **state)
{
    (void)state;
    static const struct {
        const char *layout;
        bool doubted;
    } layouts[] = {{"thesis", true}, {"radix", true}, {"integer", false}, {"compact", false}};
    for (size_t i = 0; i < sizeof layouts / sizeof *layouts; i++)
        for (int principled = 0; principled < 2; principled++) {
            MatcOptions options = quick();
            options.layout = layouts[i].layout;
            MatcDocument *document = read_text(
                principled ? "material: Principled\nroughness: 0.25\n" : "material: Phong\n",
                &options);
            MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
            const char *reported = matc_program_diagnostics(program, MATC_TEXT);
            const bool doubted = strstr(reported, "cannot store roughness, reflectance, model: the "
                                                  "surface is shaded as a Phong") != NULL;
            assert_true(matc_ok(program));
            assert_int_equal(doubted, principled && layouts[i].doubted);
            assert_true(!doubted || strstr(reported, "test.yaml:1:11"));
            matc_program_free(program);
            matc_document_free(document);
        }
}

/* Every row is a formula without a fault, every loss is said where it is one, and not where nothing
 * is lost. */
static void losses_are_reported(void **state)
{
    (void)state;
    char text[512];
    for (int i = 0; i < loss_count; i++) {
        const ParamRow *param = &param_table[loss_table[i].param];
        char *reported;
        const bool specular = strstr(loss_table[i].formula, "useSpecularWorkflow *") != NULL;
        snprintf(text, sizeof text,
                 "material: %s\n%s%s: { param: value, default: [0.5, 0.25, 0.125] }\n%s",
                 kind_table[param->kind].name, specular ? "useSpecularWorkflow: true\n" : "",
                 param->name,
                 param->kind == KIND_glTF                     ? "metallicFactor: 0\n"
                 : strstr(loss_table[i].formula, "metalness") ? "metalness: 1\n"
                                                              : "");
        free(values_at(text, "", &reported));
        assert_non_null(strstr(reported, loss_table[i].what));
        assert_non_null(strstr(reported, param->name));
        free(reported);
    }
    for (int kind = 0; kind < KIND_COUNT; kind++) {
        char *reported;
        bool foreign = false;
        for (int i = 0; i < translation_count; i++)
            foreign |= translation_table[i].from == (Kind)kind;
        snprintf(text, sizeof text, "material: %s\n", kind_table[kind].name);
        if (!foreign)
            continue;
        free(values_at(text, "", &reported));
        assert_string_equal(reported, "");
        free(reported);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(published_values),
        cmocka_unit_test(widths_are_kept),
        cmocka_unit_test(thick_glass_is_no_thin_wall),
        cmocka_unit_test(same_programs),
        cmocka_unit_test(a_phong_becomes_a_principled),
        cmocka_unit_test(layouts_without_the_model_are_doubted),
        cmocka_unit_test(losses_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
