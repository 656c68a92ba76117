/* Objects that are drawn more than once: instances of definitions, by their matrices and
 * materials; refused scenes with the place of the error. */
#include <stdio.h>
#include "tests/scene_text.h"

static void faults(void **state)
{
    (void)state;
    static const struct {
        const char *text, *reported;
    } cases[] = {
        {RED "objects: [{ object: Instance, material: red }]\n",
         "2:11: error: Instance requires 'of'"},
        {RED "objects: [{ object: Instance, of: fri }]\ndefs: { fir: { object: Box, material: red "
             "} }\n",
         "2:35: error: no definition 'fri' in `defs:`; did you mean 'fir'?"},
        {RED "objects: [{ object: Instance, of: fir }]\n",
         "2:35: error: no definition 'fir' in `defs:`"},
        {RED "objects: [{ object: Instance, of: [fir] }]\n",
         "2:35: error: of expects the name of an object under `defs:`, not a list"},
        {RED "objects: [{ object: Instance, of: fir }]\ndefs: { fir: { map: Checker } }\n",
         "2:35: error: of expects the name of an object under `defs:`, not a map or a material"},
        {RED "objects: [{ object: Instance, of: fir }]\ndefs: { fir: { object: Box } }\n",
         "3:14: error: Box requires 'material'"},
        {RED "objects: [{ object: Instance, of: fir, size: 2 }]\ndefs: { fir: { object: Box, "
             "material: red } }\n",
         "2:40: error: Instance has no parameter 'size'; it has of, transform, material, name"},
        /* a definition is read where something instances it, and where nothing does */
        {RED "objects: [{ object: Instance, of: fir }]\ndefs: { fir: { object: Box, sice: 2, "
             "material: red } }\n",
         "3:29: error: Box has no parameter 'sice'; did you mean 'size'?"},
        {RED "objects: []\ndefs: { fir: { object: Box, sice: 2, material: red } }\n",
         "3:29: error: Box has no parameter 'sice'; did you mean 'size'?"},
        {RED "objects: []\ndefs: { fir: { object: Box, material: { material: Phnog } } }\n",
         "3:51: error: unknown material 'Phnog'; did you mean 'Phong'?"},
        {RED "objects: [{ object: Instance, of: a }]\ndefs:\n  a: { object: Instance, of: a }\n",
         "4:30: error: the definition 'a' contains itself"},
        {RED "objects: [{ object: Instance, of: a }]\ndefs:\n  a: { object: Group, objects: [{ "
             "object: Instance, of: b }] "
             "}\n  b: { object: Group, objects: [{ object: Instance, of: a }] }\n",
         "5:57: error: the definition 'a' contains itself"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_fault(cases[i].text, cases[i].reported);
}

/* An instance's content stands under its matrix, in the order of the document; if it has no
 * material, it has the instance's; a map of `defs:` beside it is one as ever. */
static void instances(void **state)
{
    (void)state;
    MatcDocument *document;
    Scene *scene = read_fine(
        "materials: { red: { material: Phong, diffuse: { ref: checks } }, blue: { material: RGBA, "
        "b: 1 } }\n"
        "defs:\n"
        "  pair:\n"
        "    object: Group\n"
        "    transform: { translation: [0, 0, 1] }\n"
        "    objects: [{ object: Sphere, radius: 2, material: red }, { object: Box }]\n"
        "  row: { object: Group, transform: { scale: 2 }, objects: [{ object: Instance, of: pair, "
        "transform: { "
        "translation: [1, 0, 0] } }] }\n"
        "  checks: { map: Checker }\n"
        "  nobody: { object: Cone }\n"
        "objects:\n"
        "- { object: Instance, of: row, material: blue, transform: { translation: [10, 0, 0] } }\n"
        "- { object: Instance, of: pair, material: red }\n",
        &document);
    static const struct {
        SceneKind kind;
        int material;
        double image[3];
    } expected[] = {{SCENE_Sphere, 1, {14, 4, 8}},
                    {SCENE_Box, 0, {14, 4, 8}},
                    {SCENE_Sphere, 1, {1, 2, 4}},
                    {SCENE_Box, 1, {1, 2, 4}}};
    assert_int_equal(scene->object_count, 4);
    assert_int_equal(scene->material_count, 2);
    for (int i = 0; i < 4; i++) {
        double image[3];
        assert_int_equal(scene->objects[i].kind, expected[i].kind);
        assert_int_equal(scene->objects[i].material, expected[i].material);
        apply(&scene->objects[i].world_from_local, (double[]){1, 2, 3}, image);
        assert_near(image, expected[i].image, 3, 1e-12);
    }
    forget(scene, document);
}

/* A definition that nothing instances has no material in use, and no plane that a camera could cut;
 * what comes after it in the scene has. */
static void unused(void **state)
{
    (void)state;
    MatcDocument *document;
    Scene *scene =
        read_fine("materials: { red: { material: RGBA, r: 1 }, blue: { material: RGBA, b: 1 } }\n"
                  "camera: { camera: Orthographic, size: 6 }\n"
                  "defs: { ground: { object: Group, objects: [{ object: Plane, material: blue }, { "
                  "object: Box }] } }\n"
                  "objects: [{ object: Box, material: red }]\n"
                  "sky: blue\n",
                  &document);
    assert_int_equal(scene->object_count, 1);
    assert_int_equal(scene->material_count, 2);
    assert_int_equal(scene->sky, 1);
    forget(scene, document);
}

/* matc compiles the materials of a scene, whatever objects its `defs:` have; in a document of
 * materials these are no definitions. */
static void materials_alone(void **state)
{
    (void)state;
    static const char scene[] = RED "defs: { fir: { object: Box } }\nobjects: []\n",
                      none[] = RED "defs: { fir: { object: Box } }\n";
    MatcOptions options;
    matc_options_init(&options);
    MatcDocument *document = matc_read("scene.yaml", scene, sizeof scene - 1, &options);
    assert_string_equal(matc_diagnostics(document, MATC_TEXT), "");
    assert_int_equal(matc_material_count(document), 1);
    matc_document_free(document);
    document = matc_read("materials.yaml", none, sizeof none - 1, &options);
    assert_int_equal(matc_error_count(document), 1);
    matc_document_free(document);
}

/* Definitions that instance the next four times would be 4^30 objects; a chain of them is as deep
 * as it is long. */
static void instance_bombs(void **state)
{
    (void)state;
    static const struct {
        int length, times;
        const char *reported;
    } cases[] = {{30, 4, "more than 1048576 objects and groups"},
                 {1000, 1, "values are nested deeper than 256 levels"},
                 {100, 1, NULL}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        static char text[1 << 17];
        size_t size =
            (size_t)snprintf(text, sizeof text,
                             RED "objects: [{ object: Instance, of: d1 }]\ndefs:\n  d%d: { "
                                 "object: Box, material: red }\n",
                             cases[k].length);
        for (int i = 1; i < cases[k].length; i++) {
            size += (size_t)snprintf(text + size, sizeof text - size,
                                     "  d%d: { object: Group, objects: [", i);
            for (int t = 0; t < cases[k].times; t++)
                size += (size_t)snprintf(text + size, sizeof text - size,
                                         "%s{ object: Instance, of: d%d }", t ? ", " : "", i + 1);
            size += (size_t)snprintf(text + size, sizeof text - size, "] }\n");
        }
        MatcDocument *document;
        Scene *scene = read_text(text, &document);
        const char *reported = matc_diagnostics(document, MATC_TEXT);
        assert_true(cases[k].reported ? !scene && strstr(reported, cases[k].reported)
                                      : scene && scene->object_count == 1);
        forget(scene, document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faults),         cmocka_unit_test(instances),
        cmocka_unit_test(unused),         cmocka_unit_test(materials_alone),
        cmocka_unit_test(instance_bombs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
