/* Errors of scenes, with their places and texts; several errors in one run; aliases that would
 * expand to 4^30 objects. */
#include "tests/test.h"
#include <stdio.h>
#include "tests/scene_text.h"

/* The first line of the message; the place is in the source. */
static void faults(void **state)
{
    (void)state;
    static const struct {
        const char *text, *reported;
    } cases[] = {
        {RED "objects: [{ object: Spere, material: red }]\n",
         "2:21: error: unknown object 'Spere'; did you mean 'Sphere'?"},
        {RED "objects: [{ object: Sphere, radios: 2, material: red }]\n",
         "2:29: error: Sphere has no parameter 'radios'; did you mean 'radius'?"},
        {RED "indirect: { quality: best }\nobjects: []\n",
         "2:22: error: quality expects draft, normal or fine, not 'best'"},
        {RED "indirect: { preset: draft }\nobjects: []\n",
         "2:21: error: preset expects none, thesisMarch, thesisPoints, thesisBuddha, thesisSheep "
         "or thesisDragons, not 'draft'"},
        {RED "objects: [{ object: Sphere, radius: big, material: red }]\n",
         "2:37: error: radius expects a number, not 'big'"},
        {RED "objects: [{ object: Sphere, radius: .nan, material: red }]\n",
         "2:37: error: '.nan' is not a valid number; use decimal digits, a point, an exponent"},
        {RED "objects: [{ object: Sphere, radius: 1e999, material: red }]\n", NULL},
        {RED "objects: [{ object: Sphere, radius: -1, material: red }]\n",
         "2:37: error: radius is -1.0; it must be from 0.000001 to 1e+09"},
        {RED "objects: [{ object: Sphere, radius: { param: r, default: 1 }, material: red }]\n",
         "2:37: error: radius cannot be a param: values of a scene are not uniforms of a program"},
        {RED "objects: [{ object: Sphere, material: blue }]\n",
         "2:39: error: the document has no material 'blue'; there are red"},
        {RED "objects: [{ object: Sphere, material: rde }]\n",
         "2:39: error: the document has no material 'rde'; did you mean 'red'?"},
        {RED "objects: [{ object: Sphere }]\n", "2:11: error: Sphere requires 'material'"},
        {RED "objects: [{ object: Sphere, material: { material: Phnog } }]\n",
         "2:51: error: unknown material 'Phnog'; did you mean 'Phong'?"},
        {RED "objects: [{ object: Sphere, material: [red] }]\n",
         "2:39: error: material expects a name, a material, or `{ file: name }`, not a list"},
        {RED "objects: [{ object: Sphere, material: { file: nowhere.yaml } }]\n",
         "2:47: error: cannot read 'nowhere.yaml': No such file or directory"},
        {RED "objects: [{ object: Sphere, material: { file: x.yaml, materials: red } }]\n",
         "2:55: error: a material from a file has the keys 'file' and 'material', not 'materials'"},
        {RED "objects: [{ object: Mesh, file: nowhere.obj, material: red }]\n",
         "2:33: error: cannot read 'nowhere.obj': No such file or directory"},
        {RED "objects: [{ object: Mesh, file: mesh.max, material: red }]\n",
         "2:33: error: cannot read 'mesh.max': a mesh is a file .obj, .gltf, .glb or .ply"},
        {RED "objects: [{ object: Mesh, material: red }]\n", "2:11: error: Mesh requires 'file'"},
        {RED "objects: { object: Sphere }\n", "2:10: error: objects expects a list, not an object"},
        {RED "objects: [Sphere]\n",
         "2:11: error: missing key `object:`; the object is one of Group, Scatter, Instance, "
         "Sphere, Box, Cylinder, Cone, Parallelogram, Plane, Mesh, written `{ object: Sphere }`"},
        {RED "objects: [{ object: Cube, material: red }]\n",
         "2:21: error: unknown object 'Cube'; here it is Box"},
        {RED "objects: [{ object: Box, position: [0, 0, 1], material: red }]\n",
         "2:26: error: Box has no parameter 'position'; here it is transform: { translation: [x, "
         "y, z] }"},
        {RED "lights: [{ light: Sun }]\nobjects: []\n",
         "2:19: error: unknown light 'Sun'; here it is Directional"},
        {RED "objects: []\ntoneMapping: Filmic\n",
         "3:14: error: missing key `toneMapping:`; the toneMapping is one of Clamp, Filmic, "
         "Shoulder, Exponential, Linear, ReinhardDevlin, Drago, written `{ toneMapping: Filmic }`"},
        {RED "objects: []\ncamera: { position: [0, 0, 3] }\n",
         "3:9: error: missing key `camera:`; the camera is one of Perspective, Orthographic, "
         "written `{ camera: Perspective, ... }`"},
        {RED "objects: [{ Object: Sphere }]\n",
         "2:13: error: 'Object' must be written 'object'; names are case-sensitive"},
        {RED "objects: [{ object: Sphere, material: red, transform: { scale: [1, 0, 1] } }]\n",
         "2:55: error: the transformation makes it flat"},
        {RED "objects: [{ object: Sphere, material: red, transform: { scale: 1e38 } }]\n",
         "2:55: error: the transformation leads too far away"},
        {RED
         "objects: [{ object: Sphere, radius: 1e9, material: red, transform: { scale: 1e25 } }]\n",
         "2:68: error: the transformation leads too far away"},
        {RED "objects: [{ object: Scatter, count: 257, objects: [{ object: Plane, material: red }] "
             "}]\n",
         "2:52: error: more than 256 planes"},
        {RED "objects: [{ object: Sphere, material: red, transform: { size: 2 } }]\n",
         "2:57: error: a transform has no parameter 'size'"},
        {RED "objects: [{ object: Plane, material: red, transform: { shear: [1, 0, 0] } }]\n",
         "2:54: error: the transform does not keep x and y of a plane perpendicular"},
        {RED "objects: [{ object: Parallelogram, material: red, u: [1, 1, 0], v: [2, 2, 0] }]\n",
         "2:68: error: u and v are parallel"},
        {RED "objects: [{ object: Sphere, detail: 2, material: red }]\n",
         "2:37: error: detail is 2; it must be from 3 to 1024"},
        {RED "lights: [{ light: Pont }]\n",
         "2:19: error: unknown light 'Pont'; did you mean 'Point'?"},
        {RED "lights: [{ light: Point, shadows: soft }]\n",
         "2:35: error: shadows expects none, map, silhouette, hybrid or exact, not 'soft'"},
        {RED "lights: [{ light: Point, shadows: \"true\" }]\n",
         "2:35: error: shadows expects none, map, silhouette, hybrid or exact, not 'true'"},
        {RED "lights: [{ light: Ambient, shadows: true }]\n",
         "2:28: error: Ambient has no parameter 'shadows'; it has color, intensity, name"},
        {RED "shadowMaps: { size: 8 }\nlights: []\n",
         "2:21: error: size is 8; it must be from 16 to 8192"},
        {RED "tools: { gridCells: 0 }\nlights: []\n",
         "2:21: error: gridCells is 0; it must be from 1 to 1000"},
        {RED "tools: { grids: true }\n",
         "2:10: error: Tools has no parameter 'grids'; did you mean 'grid'?"},
        {RED "shadowMaps: { filter: 9 }\nlights: []\n",
         "2:23: error: filter is 9; it must be from 0 to 8"},
        {RED "lights: [{ light: Directional, direction: [0, 0, 0] }]\n",
         "2:43: error: direction has no direction"},
        {RED "lights: [{ light: Spot, innerAngle: 40 }]\n",
         "2:37: error: the inner angle exceeds the outer angle"},
        {RED "voxels: { size: 100 }\nobjects: []\n",
         "2:17: error: 100 voxels along an edge must be a power of two"},
        {RED "voxels: { size: 1024 }\nobjects: []\n",
         "2:17: error: size is 1024; it must be from 32 to 512"},
        {RED "displacement: { method: bisection, level: 8 }\nobjects: []\n",
         "2:43: error: bisection does not divide edges by a number of parts; use `triangles` or "
         "`pixels`"},
        {RED "displacement: { pixels: 2 }\nobjects: []\n",
         "2:25: error: method mesh divides triangles uniformly; `pixels` needs the method "
         "`bisection`, `auto`, `grid` or `tessellation`"},
        {RED "displacement: { method: traced, pixels: 2 }\nobjects: []\n",
         "2:41: error: method traced divides triangles uniformly; `pixels` needs the method "
         "`bisection`, `auto`, `grid` or `tessellation`"},
        {RED "displacement: { method: grid, level: 65 }\nobjects: []\n",
         "2:38: error: level is 65; it must be from 0 to 64"},
        {RED "lights: [{ light: Sky }]\n", "2:10: error: the scene has no sky that can emit light"},
        {RED "lights: [{ light: Area, u: [1, 1, 0], v: [-2, -2, 0] }]\n",
         "2:42: error: u and v are parallel"},
        {RED "lights: [{ light: Area, shadows: exact }]\n",
         "2:34: error: an Area light casts shadows by map or none, not by exact"},
        {RED "lights: [{ light: Area, bothSides: 2 }]\n",
         "2:36: error: bothSides expects true or false, not the number 2"},
        {RED "camera: { camera: Perspective, target: [0, -5, 2] }\n",
         "2:40: error: the vector from position to target has no direction"},
        {RED "camera: { camera: Perspective, position: [0, 0, 5] }\n",
         "2:9: error: up, seen along the view, has no direction"},
        {RED "camera: { camera: Fisheye }\n",
         "2:19: error: unknown camera 'Fisheye'; there are Perspective, Orthographic"},
        {RED
         "camera: { camera: Orthographic, size: 6 }\nobjects: [{ object: Plane, material: red }]\n",
         "2:9: error: a plane is behind this camera in part of the image; move its position back, "
         "and add the distance to its depth"},
        {RED "camera: { camera: Orthographic, size: 6 }\nobjects: [{ object: Plane, material: red, "
             "transform: { "
             "translation: [0, 0, -100] } }, { object: Plane, material: red }]\n",
         "2:9: error: a plane is behind this camera in part of the image; move its position back, "
         "and add the distance to its depth"},
        {RED "image: { width: 0 }\n", "2:17: error: width is 0; it must be from 1 to 16384"},
        {RED "image: { width: 2.5 }\n",
         "2:17: error: width expects an integer, not the number 2.5"},
        {RED "toneMapping: { toneMapping: Gamma }\n",
         "2:29: error: unknown toneMapping 'Gamma'; there are Clamp, Filmic, Shoulder, "
         "Exponential, Linear, ReinhardDevlin, Drago"},
        {RED "toneMapping: { toneMapping: Drago, bias: 2 }\n",
         "2:42: error: bias is 2.0; it must be from 0.01 to 1.0"},
        {RED "toneMapping: { toneMapping: ReinhardDevlin, exposure: 1 }\n",
         "2:45: error: ReinhardDevlin has no parameter 'exposure'; it has intensity, contrast, "
         "chromaticAdaptation, "
         "lightAdaptation"},
        {RED "image: { tiles: grey }\n", "2:17: error: tiles expects true or false, not 'grey'"},
        {RED "sky: blue\n", "2:6: error: the document has no material 'blue'; there are red"},
        {RED "lights: []\nshadows: true\n", "3:1: error: a document has no key 'shadows'; here it "
                                            "is shadowMaps of the scene, or `shadows:` of a light"},
        {RED "cammera: { camera: Perspective }\nlights: []\n",
         "2:1: error: a document has no key 'cammera'; did you mean 'camera'?"},
        {"materials: [red]\nlights: []\n", "1:12: error: materials expects an object, not a list"},
        {"materials: { red: { material: Phnog } }\nlights: []\n",
         "1:31: error: unknown material 'Phnog'; did you mean 'Phong'?"},
        {"colors: sRGB\nlights: []\n", NULL},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_fault(cases[i].text, cases[i].reported);
}

/* One run reports several errors, each once, though an alias repeats one of them. */
static void several(void **state)
{
    (void)state;
    MatcDocument *document;
    assert_null(read_text("objects:\n- &a { object: Spere }\n- *a\n- *a\n- { object: Box, sice: 2 "
                          "}\nlights: [{ light: Sun }]\n",
                          &document));
    assert_int_equal(matc_error_count(document), 3);
    matc_document_free(document);
}

/* Without a key of a scene a document is one of materials, as ever. */
static void materials_alone(void **state)
{
    (void)state;
    MatcDocument *document;
    assert_null(read_text("material: Phong\n", &document));
    assert_int_equal(matc_material_count(document), 1);
    assert_int_equal(matc_error_count(document), 0);
    matc_document_free(document);
    assert_null(read_text("material: Phong\nlights: []\n", &document));
    assert_int_equal(matc_error_count(document), 1);
    matc_document_free(document);
}

/* Lists of lists by aliases would be 4^30 objects, or as many empty groups. */
static void alias_bombs(void **state)
{
    (void)state;
    static const char *const innermost[] = {"{ object: Box, material: red }", "{ object: Group }"};
    for (int k = 0; k < 2; k++) {
        char text[4096];
        size_t size = (size_t)snprintf(text, sizeof text, RED "objects:\n- &a0 %s\n", innermost[k]);
        for (int i = 1; i <= 30; i++)
            size +=
                (size_t)snprintf(text + size, sizeof text - size,
                                 "- &a%d { object: Group, objects: [*a%d, *a%d, *a%d, *a%d] }\n", i,
                                 i - 1, i - 1, i - 1, i - 1);
        MatcDocument *document;
        assert_null(read_text(text, &document));
        assert_non_null(
            strstr(matc_diagnostics(document, MATC_TEXT), "more than 1048576 objects and groups"));
        matc_document_free(document);
    }
}

/* Meshes that differ are bounded by their triangles, before one is made: 64 spheres of 1,024 steps
 * are 2^26. */
static void triangles(void **state)
{
    (void)state;
    enum { STEPS = 1024, SPHERES = (1 << 26) / (STEPS * STEPS) };
    static char text[1 << 14];
    MatcDocument *document;
    for (int more = 0; more < 2; more++) {
        size_t size = (size_t)snprintf(text, sizeof text, RED "objects:\n");
        for (int i = 0; i < 2 * SPHERES + more; i++) /* each of them twice */
            size +=
                (size_t)snprintf(text + size, sizeof text - size,
                                 "- { object: Sphere, detail: %d, radius: %d, material: red }\n",
                                 STEPS, i % 2 ? i : i + 1);
        if (more)
            assert_fault(text, "131:3: error: more than 67108864 triangles in distinct meshes");
        else
            scene_free(read_heavy(text, &document)), matc_document_free(document);
    }
}

/* A black picture is not drawn without a word; light of any kind, and an empty list, say that it is
 * meant. */
static void darkness_is_warned_of(void **state)
{
    (void)state;
#define BALL(material) "objects: [{ object: Sphere, material: { " material " } }]\n"
    static const struct {
        const char *text;
        bool warned;
    } rows[] = {
        {BALL("material: Phong, diffuse: red"), true},
        {BALL("material: Principled, emission: 0, emissionColor: red"), true},
        /* which lights nothing by itself */
        {"sky: { material: RGBA, r: 1 }\n" BALL("material: Phong"), true},
        {BALL("material: Phong, emissive: 0.1"), false},
        {BALL("material: Phong, emissive: { map: Checker, color1: 0, color2: [0, 0, 1] }"), false},
        {BALL("material: Principled, emission: 2"), false},
        {BALL("material: glTF, emissiveFactor: [0, .5, 0]"), false},
        {"lights: []\n" BALL("material: Phong"), false},
        {"lights: [{ light: Ambient }]\n" BALL("material: Phong"), false},
        {"sky: { material: RGBA, r: 1 }\nlights: [{ light: Sky }]\n" BALL("material: Phong"),
         false},
        {"sky: { material: RGBA, r: 1 }\nobjects: []\n", false},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        Scene *scene = NULL;
        MatcOptions options;
        matc_options_init(&options);
        MatcDocument *document =
            scene_read("scene.yaml", rows[i].text, strlen(rows[i].text), &options, &scene);
        const char *reported = matc_diagnostics(document, MATC_TEXT);
        if (!scene || (strstr(reported, "[-Wno_light]") != NULL) != rows[i].warned)
            fail_msg("%s: %s", rows[i].text, reported);
        forget(scene, document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(darkness_is_warned_of),
        cmocka_unit_test(faults),
        cmocka_unit_test(several),
        cmocka_unit_test(materials_alone),
        cmocka_unit_test(alias_bombs),
        cmocka_unit_test(triangles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
