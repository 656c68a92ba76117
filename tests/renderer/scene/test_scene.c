/* Parsed scenes: matrices, cameras and lights by closed forms; solids by their volume, and by
 * the effect of a step of u or v. */
#include "runtime/tessellate/scene_solid.h"
#include "tests/test.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "compiler/base/session.h"
#include "tests/scene_text.h"
#include "tests/vectors.h"

/* Shear, scale, turn about x, y, z, shift: semantics of XYZTransform. Groups stand around. Numbers
 * worked out by hand. */
static void transformations(void **state)
{
    (void)state;
    static const struct {
        const char *object;
        double point[3], image[3];
    } cases[] = {
        {"{ object: Sphere, material: red }", {1, 2, 3}, {1, 2, 3}},
        {"{ object: Sphere, material: red, transform: { scale: 2 } }", {1, 2, 3}, {2, 4, 6}},
        {"{ object: Sphere, material: red, transform: { translation: [1, 0, -1] } }",
         {1, 2, 3},
         {2, 2, 2}},
        {"{ object: Sphere, material: red, transform: { rotation: [0, 0, 1.5707963267948966] } }",
         {1, 2, 3},
         {-2, 1, 3}},
        {"{ object: Sphere, material: red, transform: { rotation: [1.5707963267948966, 0, 0] } }",
         {1, 2, 3},
         {1, -3, 2}},
        {"{ object: Sphere, material: red, transform: { rotation: [0, 1.5707963267948966, 0] } }",
         {1, 2, 3},
         {3, 2, -1}},
        /* about x, then about z */
        {"{ object: Sphere, material: red, transform: { rotation: [1.5707963267948966, 0, "
         "1.5707963267948966] } }",
         {1, 2, 3},
         {3, 1, 2}},
        {"{ object: Sphere, material: red, transform: { shear: [10, 100, 1000], scale: [1, 2, 1] } "
         "}",
         {1, 2, 3},
         {321, 6004, 3}},
        {"{ object: Sphere, material: red, transform: { matrix: [0, 1, 0, 7, 0, 0, 1, 8, 1, 0, 0, "
         "9, 0, 0, 0, 1] } }",
         {1, 2, 3},
         {9, 11, 10}},
        {"{ object: Group, transform: { translation: [10, 0, 0] }, objects: [{ object: Group, "
         "transform: { scale: 2 }, "
         "objects: [{ object: Sphere, material: red, transform: { translation: [0, 1, 0] } }] }] }",
         {1, 2, 3},
         {12, 6, 6}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[1024];
        double image[3];
        MatcDocument *document;
        snprintf(text, sizeof text, RED "objects: [%s]\n", cases[i].object);
        Scene *scene = read_fine(text, &document);
        assert_int_equal(scene->object_count, 1);
        apply(&scene->objects[0].world_from_local, cases[i].point, image);
        assert_near(image, cases[i].image, 3, 1e-12 * 6004);
        forget(scene, document);
    }
}

/* A material exists once for all its users: by name, by alias, inherited; an unused one does not
 * exist. */
static void materials(void **state)
{
    (void)state;
    MatcDocument *document;
    Scene *scene = read_fine("materials: { unused: { material: Phong }, red: { material: RGBA, r: "
                             "1 }, inline2: { material: RGBA } }\n"
                             "objects:\n"
                             "- { object: Sphere, material: red }\n"
                             "- { object: Sphere, material: &blue { material: RGBA, b: 1 } }\n"
                             "- { object: Box, material: *blue }\n"
                             "- object: Group\n"
                             "  material: red\n"
                             "  objects: [{ object: Box }, { object: Box, material: inline2 }]\n"
                             "sky: { material: RGBA, b: .5 }\n",
                             &document);
    static const int expected[] = {0, 1, 1, 0, 2};
    assert_int_equal(scene->object_count, 5);
    for (int i = 0; i < 5; i++)
        assert_int_equal(scene->objects[i].material, expected[i]);
    assert_int_equal(scene->material_count, 4);
    assert_int_equal(scene->sky, 3);
    assert_string_equal(matc_material_name(scene->materials[0].document, scene->materials[0].index),
                        "red");
    assert_string_equal(matc_material_name(scene->materials[2].document, scene->materials[2].index),
                        "inline2");
    assert_int_equal(matc_material_count(document), 5);
    forget(scene, document);
}

static void cameras_and_lights(void **state)
{
    (void)state;
    MatcDocument *document;
    Scene *scene =
        read_fine(RED "camera: { camera: Perspective, position: [3, 0, 4], angle: 90, near: .5 }\n"
                      "image: { width: 64, height: 32 }\n"
                      "lights:\n"
                      "- { light: Spot, direction: [0, 3, 4], innerAngle: 0, outerAngle: 60, "
                      "color: [1, .5, 0], intensity: 4 }\n"
                      "- { light: Point, position: [1, 2, 3], color: \"#ff0000\" }\n"
                      "toneMapping: { toneMapping: Filmic, exposure: -2 }\n",
                  &document);
    assert_int_equal(scene->width, 64);
    assert_int_equal(scene->height, 32);
    assert_near(scene->camera.back, (double[]){.6, 0, .8}, 3, 1e-15);
    assert_near(scene->camera.right, (double[]){0, 1, 0}, 3, 1e-15);
    assert_near(scene->camera.up, (double[]){-.8, 0, .6}, 3, 1e-15);
    assert_near(&scene->camera.half, (double[]){1}, 1, 1e-15);
    assert_near(&scene->camera.near, (double[]){.5}, 1, 0);
    assert_int_equal(scene->light_count, 2);
    assert_near(scene->lights[0].direction, (double[]){0, .6, .8}, 3, 1e-15);
    assert_near(scene->lights[0].light, (double[]){4, 2, 0}, 3, 0);
    assert_near(&scene->lights[0].outer_cosine, (double[]){.5}, 1, 1e-15);
    assert_near(&scene->lights[0].inner_cosine, (double[]){1}, 1, 0);
    assert_near(scene->lights[1].light, (double[]){1, 0, 0}, 3, 0);
    assert_int_equal(scene->tone, SCENE_Filmic);
    assert_near(&scene->exposure, (double[]){.25}, 1, 0);
    assert_int_equal(scene->sky, -1);
    forget(scene, document);
}

static void subtract(const float *a, const float *b, double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = (double)a[i] - b[i];
}

/* Sum over the triangles of a . (b x c) / 6: the volume, where all turn counterclockwise and none
 * is missing. */
static double volume_of(const Shape *shape)
{
    static const float origin[3];
    double sum = 0, a[3], b[3], c[3], product[3];
    for (int i = 0; i < shape->index_count; i += 3) {
        subtract(shape->vertices[shape->indices[i]].position, origin, a);
        subtract(shape->vertices[shape->indices[i + 1]].position, origin, b);
        subtract(shape->vertices[shape->indices[i + 2]].position, origin, c);
        cross(b, c, product);
        sum += dot(a, product) / 6;
    }
    return sum;
}

/* Every triangle has its normals on its front, of length 1, but near a tip; an edge is the step
 * that dP/du and dP/dv promise, up to the square of its length. */
static void check_triangles(const Shape *shape, double within)
{
    for (int i = 0; i < shape->index_count; i += 3) {
        const ShapeVertex *v[3];
        double edge[2][3], front[3];
        for (int k = 0; k < 3; k++)
            v[k] = &shape->vertices[shape->indices[i + k]];
        subtract(v[1]->position, v[0]->position, edge[0]);
        subtract(v[2]->position, v[0]->position, edge[1]);
        cross(edge[0], edge[1], front);
        for (int k = 0; k < 3; k++) {
            const double n[3] = {v[k]->normal[0], v[k]->normal[1], v[k]->normal[2]};
            assert_true(dot(n, n) > 0 && dot(n, n) < 1 + 1e-6);
            assert_true(dot(front, front) < 1e-18 || dot(front, n) > 0);
        }
        for (int k = 1; k < 3; k++)
            for (int component = 0; component < 3; component++) {
                const double du = v[k]->uv[0] - v[0]->uv[0], dv = v[k]->uv[1] - v[0]->uv[1];
                const double step =
                    (v[0]->tangentU[component] + v[k]->tangentU[component]) / 2. * du +
                    (v[0]->tangentV[component] + v[k]->tangentV[component]) / 2. * dv;
                assert_true(fabs(step - edge[k - 1][component]) <= within);
            }
    }
}

/* A method by its name, or as a truth value; a light without shadows has none; and one method
 * for all lights with shadows. */
static void methods_of_shadows(void **state)
{
    (void)state;
    MatcDocument *document;
    Scene *scene =
        read_fine(RED "lights: [{ light: Point }, { light: Point, shadows: map }, { light: Spot, "
                      "shadows: true }, "
                      "{ light: Directional, shadows: none }, { light: Point, shadows: false }, "
                      "{ light: Ambient }]\n",
                  &document);
    const Keyword reported[] = {KEYWORD_Shadows_map,  KEYWORD_Shadows_map,  KEYWORD_Shadows_map,
                                KEYWORD_Shadows_none, KEYWORD_Shadows_none, KEYWORD_Shadows_none};
    assert_int_equal(scene->light_count, 6);
    for (int i = 0; i < 6; i++)
        assert_int_equal(scene->lights[i].shadows, reported[i]);
    scene_lights_shadow(scene, KEYWORD_Shadows_none);
    for (int i = 0; i < 6; i++)
        assert_false(scene_light_casts(&scene->lights[i]));
    scene_lights_shadow(scene, KEYWORD_Shadows_map);
    for (int i = 0; i < 6; i++)
        assert_false(scene_light_casts(&scene->lights[i]));
    forget(scene, document);
}

static void solids(void **state)
{
    (void)state;
    /* a circle of n steps has sin(2 pi / n) n / 2 pi of its area */
    const double part = sin(2 * PI / 192) * 192 / (2 * PI), part_7 = sin(2 * PI / 7) * 7 / (2 * PI);
    const struct {
        SceneObject object;
        double volume, within; /* of the volume, relative; */
        double step;           /* an edge equals that of the derivatives within this tolerance */
    } cases[] = {
        {{.kind = SCENE_Sphere, .numbers = {2, 192}}, 4 / 3. * PI * 8, 2e-3, 1e-3},
        {{.kind = SCENE_Sphere, .numbers = {2, 33}}, 4 / 3. * PI * 8, 2e-2, 5e-2},
        {{.kind = SCENE_Sphere, .numbers = {2, 32}}, 4 / 3. * PI * 8, 2e-2, 5e-2},
        {{.kind = SCENE_Box, .numbers = {1, 2, 3}}, 6, 1e-6, 1e-3},
        {{.kind = SCENE_Cylinder, .numbers = {.5, 3, 192}}, PI * .25 * 3 * part, 1e-6, 1e-3},
        {{.kind = SCENE_Cylinder, .numbers = {.5, 3, 7}}, PI * .25 * 3 * part_7, 1e-6, .5},
        {{.kind = SCENE_Cone, .numbers = {.5, 3, 192}}, PI * .25 * part, 1e-6, 1e-3},
        {{.kind = SCENE_Cone, .numbers = {.5, 3, 7}}, PI * .25 * part_7, 1e-6, .5},
        {{.kind = SCENE_Parallelogram, .numbers = {1, 0, 0, 1, 2, 0}}, 0, 1e-6, 1e-3},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Shape shape;
        assert_true(scene_solid(&cases[i].object, &shape));
        assert_int_equal(shape.index_count, 3 * scene_solid_triangles(&cases[i].object));
        assert_true(fabs(volume_of(&shape) - cases[i].volume) <=
                    cases[i].within * cases[i].volume + 1e-12);
        check_triangles(&shape, cases[i].step);
        shape_free(&shape);
    }
}

/* Close to the tip too, the mixed normal of a cone's side is (h x, h y, r sqrt(x^2 + y^2)) up to
 * length: 192 chords are within 1.4e-4 of their arcs. */
static void tips(void **state)
{
    (void)state;
    static const double share[3] = {.05, .05, .9};
    const double radius = .5, height = 3;
    Shape shape;
    assert_true(
        scene_solid(&(SceneObject){.kind = SCENE_Cone, .numbers = {radius, height, 192}}, &shape));
    for (int i = 0; i < shape.index_count; i += 3) {
        double p[3] = {0}, n[3] = {0};
        for (int k = 0; k < 9; k++) {
            const ShapeVertex *v = &shape.vertices[shape.indices[i + k / 3]];
            p[k % 3] += share[k / 3] * v->position[k % 3];
            n[k % 3] += share[k / 3] * v->normal[k % 3];
        }
        const double wanted[3] = {height * p[0], height * p[1], radius * hypot(p[0], p[1])};
        if (n[2] > 0) /* not of the foot */
            assert_true(dot(n, wanted) > cos(2e-4) * sqrt(dot(n, n) * dot(wanted, wanted)));
    }
    shape_free(&shape);
}

/* However long its edges are, also where the product of their lengths is no number any more, it
 * faces along z. */
static void thin_parallelograms(void **state)
{
    (void)state;
    static const double lengths[] = {1e-200, 1e-30, 1, 1e30};
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        Shape shape;
        const double length = lengths[i];
        assert_true(scene_solid(&(SceneObject){.kind = SCENE_Parallelogram,
                                               .numbers = {length, 0, 0, length, length, 0}},
                                &shape));
        for (int k = 0; k < shape.vertex_count; k++)
            assert_near((const double[]){shape.vertices[k].normal[0], shape.vertices[k].normal[1],
                                         shape.vertices[k].normal[2]},
                        (const double[]){0, 0, 1}, 3, 0);
        shape_free(&shape);
    }
}

/* `quality` and `preset` set the keys that are not given, and preset wins over quality; the other
 * keys have their defaults (steps: 0, by the method). */
static void presets_of_indirect(void **state)
{
    (void)state;
    static const struct {
        const char *keys;
        Keyword method, filter;
        int rays, steps, coarse;
        double radius;
    } cases[] = {
        {"preset: none", KEYWORD_Indirect_auto, KEYWORD_Filter_separable, 8, 0, 1, 0},
        {"quality: normal", KEYWORD_Indirect_auto, KEYWORD_Filter_separable, 8, 0, 1, 0},
        {"quality: draft", KEYWORD_Indirect_auto, KEYWORD_Filter_separable, 2, 0, 1, 0},
        {"quality: fine, method: screen", KEYWORD_Indirect_screen, KEYWORD_Filter_atrous, 64, 0, 1,
         0},
        {"filter: none, quality: fine", KEYWORD_Indirect_auto, KEYWORD_Filter_none, 64, 0, 1, 0},
        {"quality: fine, preset: thesisPoints", KEYWORD_Indirect_points, KEYWORD_Filter_none, 32, 0,
         1, 1.5},
        {"preset: thesisBuddha", KEYWORD_Indirect_march, KEYWORD_Filter_none, 32, 32, 1, 4},
        {"rays: 5, preset: thesisBuddha, method: voxels", KEYWORD_Indirect_voxels,
         KEYWORD_Filter_none, 5, 32, 1, 4},
        {"preset: thesisPoints, filter: separable", KEYWORD_Indirect_points,
         KEYWORD_Filter_separable, 32, 0, 1, 1.5},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[1024];
        MatcDocument *document;
        snprintf(text, sizeof text,
                 RED "indirect: { %s }\nobjects: [{ object: Sphere, material: red }]\n",
                 cases[i].keys);
        Scene *scene = read_fine(text, &document);
        const SceneIndirect *in = &scene->indirect;
        assert_true(in->method == cases[i].method && in->filter == cases[i].filter &&
                    in->coarse == cases[i].coarse);
        assert_true(in->rays == cases[i].rays && in->steps == cases[i].steps);
        assert_near(&in->radius, &cases[i].radius, 1, 0);
        forget(scene, document);
    }
}

static double seconds_to_read(const char *motion, int count)
{
    char text[512];
    MatcDocument *document;
    snprintf(
        text, sizeof text,
        RED
        "camera: { camera: Orthographic, position: [0, -90, 40], size: 6 }\n%s"
        "objects: [{ object: Scatter, count: %d, objects: [{ object: Sphere, material: red }] }]\n",
        motion, count);
    const double start = session_now();
    Scene *scene = count > 1 ? read_heavy(text, &document) : read_fine(text, &document);
    const double seconds = session_now() - start;
    forget(scene, document);
    return seconds;
}

/* Frames take time independent of the number of objects: both together take the sum of what each
 * takes, not the product. */
static void frames_of_many_objects(void **state)
{
    (void)state;
    static const char motion[] = "motion: { motion: Turntable, frames: 100000 }\n";
    const double frames = seconds_to_read(motion, 1), objects = seconds_to_read("", 20000);
    assert_true(seconds_to_read(motion, 20000) < 8 * (frames + objects));
}

static char folder[] = "/tmp/matc_sceneXXXXXX";

static const char *write_file(const char *name, const char *text)
{
    static char path[256];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
    return path;
}

/* A mesh keeps its file's position, with y up rotated to z up; objects share it. A file's
 * material, by its name. */
static void files(void **state)
{
    (void)state;
    char text[1024];
    MatcDocument *document;
    assert_non_null(mkdtemp(folder));
    write_file("three.obj", "v 5 0 0\nv 7 0 0\nv 5 3 0\nf 1 2 3\n");
    write_file("two.yaml", "materials: { a: { material: Phong }, b: { material: RGBA } }\n");
    write_file("bad.yaml", "material: Phong\ndifuse: 1\n");
    snprintf(text, sizeof text,
             "objects:\n- { object: Mesh, file: %s/three.obj, material: &m { file: %s/two.yaml, "
             "material: b } }\n"
             "- { object: Mesh, file: %s/three.obj, material: *m }\n",
             folder, folder, folder);
    Scene *scene = read_fine(text, &document);
    assert_int_equal(scene->mesh_count, 1);
    assert_int_equal(scene->material_count, 1);
    assert_string_equal(matc_material_name(scene->materials[0].document, scene->materials[0].index),
                        "b");
    assert_int_equal(scene->meshes[0].shape.vertex_count, 3);
    for (int i = 0; i < 3; i++) {
        const float *p = scene->meshes[0].shape.vertices[i].position;
        assert_true((p[0] == 5 || p[0] == 7) && p[1] == 0 && (p[2] == 0 || p[2] == 3));
    }
    assert_int_equal(matc_depend_count(document), 3);
    forget(scene, document);
    snprintf(text, sizeof text, "objects: [{ object: Box, material: { file: %s/bad.yaml } }]\n",
             folder);
    assert_null(read_text(text, &document));
    assert_non_null(strstr(matc_diagnostics(document, MATC_TEXT),
                           "bad.yaml:2:1: error: Phong has no parameter 'difuse'"));
    matc_document_free(document);
    snprintf(text, sizeof text,
             "objects: [{ object: Box, material: { file: %s/two.yaml, material: gold } }]\n",
             folder);
    assert_null(read_text(text, &document));
    assert_non_null(strstr(matc_diagnostics(document, MATC_TEXT),
                           "the document has no material 'gold'; there are a, b"));
    matc_document_free(document);
}

static int clean(void **state)
{
    (void)state;
    char command[300];
    snprintf(command, sizeof command, "rm -rf %s", folder);
    return system(command);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(transformations),
        cmocka_unit_test(materials),
        cmocka_unit_test(cameras_and_lights),
        cmocka_unit_test(methods_of_shadows),
        cmocka_unit_test(presets_of_indirect),
        cmocka_unit_test(solids),
        cmocka_unit_test(tips),
        cmocka_unit_test(thin_parallelograms),
        cmocka_unit_test(frames_of_many_objects),
        cmocka_unit_test_teardown(files, clean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
