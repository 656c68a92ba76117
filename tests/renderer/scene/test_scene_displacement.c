/* Displaced meshes without a picture: vertex positions, by closed forms; closed meshes stay
 * closed, bit for bit; no vertex exceeds matc's bound for its material; which objects share a
 * mesh, and refused scenes. */
#include "tests/test.h"
#include "tests/scene_whole.h"
#include "runtime/scene/scene.h"
#include "runtime/tessellate/scene_divide.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double size_of(const double v[3]) { return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

/* A triangle's number of parts, by hand: n^2 triangles, (n + 1) (n + 2) / 2 vertices. */
static void triangles_are_divided(void **state)
{
    (void)state;
    ShapeVertex corners[3] = {
        {.position = {0, 0, 0}}, {.position = {1, 0, 0}}, {.position = {0, 1, 0}}};
    uint32_t indices[3] = {0, 1, 2};
    for (int n = 1; n <= 9; n++) {
        Shape made;
        double area = 0;
        assert_true(scene_divide(
            &(Shape){.vertices = corners, .indices = indices, .vertex_count = 3, .index_count = 3},
            n, &made));
        assert_int_equal(made.index_count, 3 * n * n);
        assert_int_equal(made.vertex_count, (n + 1) * (n + 2) / 2);
        for (int i = 0; i < made.index_count; i += 3) {
            const float *a = made.vertices[made.indices[i]].position,
                        *b = made.vertices[made.indices[i + 1]].position,
                        *c = made.vertices[made.indices[i + 2]].position;
            const double twice =
                (double)(b[0] - a[0]) * (c[1] - a[1]) - (double)(b[1] - a[1]) * (c[0] - a[0]);
            assert_true(fabs(twice * n * n - 1) < 1e-5); /* all alike, and turned as the whole */
            area += twice / 2;
        }
        assert_true(fabs(area - .5) < 1e-5);
        shape_free(&made);
    }
}

#define SCENE(material, objects)                                                                   \
    "materials: { m: { material: Phong, " material                                                 \
    " } }\ndisplacement: { triangles: 3000 }\nobjects:\n" objects "\n"
#define BALL(transform)                                                                            \
    "- { object: Sphere, radius: 2, detail: 24, material: m, transform: " transform " }"
#define WAVE                                                                                       \
    "displacement: { map: Gradient, direction: [3, 0, 1], waveForm: Sin }, displacementScale: 0.2"

/* P + 0.2 sin(3 x + z) n on a ball of radius 2 / P along its own radius, in units of the world
 * whatever the object is scaled by. */
static void a_wave_moves_points_by_its_height(void **state)
{
    (void)state;
    static const double scales[] = {1, .25, 3};
    for (size_t k = 0; k < sizeof scales / sizeof *scales; k++) {
        char text[1000];
        MatcDocument *document;
        snprintf(
            text, sizeof text,
            SCENE(WAVE,
                  BALL("{ scale: [%g, %g, %g], rotation: [.3, .4, .5], translation: [1, 2, 3] }")),
            scales[k], scales[k], scales[k]);
        Scene *scene = read_scene(text, &document);
        const Shape *shape = &scene->meshes[scene->objects[0].mesh].shape;
        assert_int_equal(scene->displaced, 1);
        assert_true(scene->objects[0].kind == SCENE_Mesh && shape->base &&
                    shape->index_count / 3 >= 3000);
        for (int i = 0; i < shape->vertex_count; i++) {
            const float *p = shape->base[i], *q = shape->vertices[i].position,
                        *n = shape->vertices[i].normal;
            const double h = .2 * sin(3 * (double)p[0] + p[2]) / scales[k];
            const double miss[3] = {q[0] - p[0] - h * n[0], q[1] - p[1] - h * n[1],
                                    q[2] - p[2] - h * n[2]};
            if (size_of(miss) > 1e-6)
                fail_msg("scale %g, vertex %d: off by %g", scales[k], i, size_of(miss));
        }
        forget(scene, document);
    }
}

/* A cube whose corners move by 0.3 along the sum of three normals: along its diagonals; its edges
 * along the halves of right angles. */
static void hard_edges_have_one_way(void **state)
{
    (void)state;
    MatcDocument *document;
    Scene *scene = read_scene(
        SCENE("displacement: 0.3", "- { object: Box, size: [2, 2, 2], material: m }"), &document);
    const Shape *shape = &scene->meshes[scene->objects[0].mesh].shape;
    int on[4] = {0};
    for (int i = 0; i < shape->vertex_count; i++) {
        double want[3], sides = 0;
        for (int component = 0; component < 3; component++) {
            want[component] = fabs(shape->base[i][component]) == 1 ? shape->base[i][component] : 0;
            sides += fabs(want[component]);
        }
        on[(int)sides]++;
        for (int component = 0; component < 3; component++)
            assert_true(fabs(shape->vertices[i].position[component] - shape->base[i][component] -
                             .3 * want[component] / sqrt(sides)) < 1e-6);
    }
    assert_int_equal(on[0], 0);
    assert_int_equal(on[3], 24);
    assert_true(on[1] > on[2] && on[2] > on[3]);
    forget(scene, document);
}

/* Heights of every kind: smooth, by steps, by texture coordinates that are apart at seams and
 * edges, leaning over. */
/* Twice a triangle's area across its plane. */
static void area_of(float (*const rows)[3], const uint32_t *corners, double area[3])
{
    for (int k = 0; k < 3; k++) {
        const int u = (k + 1) % 3, v = (k + 2) % 3;
        const float *a = rows[corners[0]], *b = rows[corners[1]], *c = rows[corners[2]];
        area[k] = (double)(b[u] - a[u]) * (double)(c[v] - a[v]) -
                  (double)(b[v] - a[v]) * (double)(c[u] - a[u]);
    }
}

/* Number of a cube's faces that contain the point. */
static int faces_at(const float p[3], double half)
{
    int count = 0;
    for (int component = 0; component < 3; component++)
        count += fabs((double)p[component]) > half - 1e-6;
    return count;
}

/* Faces of a hard body move along their own normals. Outward they leave each other, and triangles
 * along edges close what is between. Inward they cross: each ends beyond the other, nearly where it
 * ended before, and those triangles lead back, turned inside out. That is the dark notch in
 * docs/pictures/hard.png, where heights are below 0. */
static void hard_faces_cross_where_they_move_inward(void **state)
{
    (void)state;
    const double height = .2, half = .5;
    for (int way = 1; way >= -1; way -= 2) {
        char text[1000];
        MatcDocument *document;
        int turned = 0, beside = 0;
        double beyond = 0;
        snprintf(text, sizeof text,
                 SCENE("displacement: 1, displacementScale: %g",
                       "- { object: Box, size: [1, 1, 1], material: m }"),
                 way * height);
        Scene *scene = read_scene(text, &document);
        const Shape *shape = &scene->meshes[scene->objects[0].mesh].shape;
        float(*moved)[3] = malloc((size_t)shape->vertex_count * sizeof *moved);
        for (int i = 0; i < shape->vertex_count; i++) {
            memcpy(moved[i], shape->vertices[i].position, sizeof *moved);
            /* it is in its face's plane, or along it */
            for (int component = 0; component < 3 && faces_at(shape->base[i], half) == 1;
                 component++)
                if (fabs((double)shape->base[i][component]) < half - 1e-6)
                    beyond = fmax(beyond, fabs((double)moved[i][component]) - half - way * height);
        }
        for (int i = 0; i < shape->index_count; i += 3) {
            double was[3], is[3];
            area_of(shape->base, &shape->indices[i], was);
            area_of(moved, &shape->indices[i], is);
            const bool inward = was[0] * is[0] + was[1] * is[1] + was[2] * is[2] < 0;
            turned += inward;
            for (int k = 0; k < 3 && inward; k++)
                if (faces_at(shape->base[shape->indices[i + k]], half) > 1) {
                    beside++;
                    break;
                }
        }
        print_message("%s: %d of %d triangles are turned, %d of these at edges; a face ends %.3f "
                      "beyond the next\n",
                      way > 0 ? "outward" : "inward", turned, shape->index_count / 3, beside,
                      beyond);
        if (way > 0)
            assert_true(turned == 0 && beyond == 0);
        else
            assert_true(turned > 100 && beside == turned && beyond > height / 2 && beyond < height);
        free(moved);
        forget(scene, document);
    }
}

static const char *const heights[] = {
    "displacement: { map: VolumeTurbulence, size: 2, octaves: 4, noiseRatio: 0.5 }, "
    "displacementScale: 0.3",
    "displacement: { map: Checker, input: { map: UVTransform, scaleU: 7, scaleV: 5 } }, "
    "displacementScale: 0.2",
    "displacement: { map: Checker, input: { map: Turbulence, input: { map: UVTransform, scaleU: "
    "3.7, scaleV: 2.3 } } }, displacementScale: 0.2",
    "displacementVector: { map: Blend, blend: [{ value: -1, input: [0.3, -0.2, 0.1] }, { value: 1, "
    "input: [-0.2, 0.3, 0.4] }], "
    "input: { map: VolumeTurbulence, size: 2 } }",
    "displacement: { map: Granite, input: { map: XYZTransform, useGlobal: true, transform: { "
    "scale: 0.7 } } }, displacementScale: 0.4",
    "displacement: -0.2",
};
static const char *const solids[] = {
    "- { object: Sphere, detail: 20, material: m }",
    "- { object: Box, size: [1, 2, 0.5], material: m, transform: { rotation: [0.1, 0.2, 0.3] } }",
    "- { object: Cylinder, radius: 0.5, height: 2, detail: 17, material: m, transform: { scale: "
    "[1, 2, -1] } }",
    "- { object: Cone, radius: 0.7, height: 1, detail: 13, material: m, transform: { shear: [0.3, "
    "0, 0.2] } }",
};

static void what_is_closed_stays_closed(void **state)
{
    (void)state;
    static const char *const division[] = {"triangles: 1",
                                           "triangles: 500",
                                           "triangles: 777",
                                           "triangles: 4000",
                                           "triangles: 20000",
                                           "method: bisection, triangles: 1",
                                           "method: bisection, triangles: 5000"};
    int shapes = 0;
    double nearest = 0;
    for (size_t h = 0; h < sizeof heights / sizeof *heights; h++)
        for (size_t s = 0; s < sizeof solids / sizeof *solids; s++)
            for (size_t t = 0; t < sizeof division / sizeof *division; t++, shapes++) {
                char text[2000];
                MatcDocument *document;
                const MatcOptions by = options();
                snprintf(text, sizeof text,
                         "materials: { m: { material: Phong, %s } }\ndisplacement: { %s "
                         "}\nobjects:\n%s\n",
                         heights[h], division[t], solids[s]);
                Scene *scene = read_scene(text, &document);
                const Shape *shape = &scene->meshes[scene->objects[0].mesh].shape;
                if (shape_body(shape) == SHAPE_BODY_none)
                    fail_msg("%s: open", text);
                MatcProgram *program = matc_compile(scene->materials[0].document,
                                                    scene->materials[0].index, MATC_KEY, &by);
                const double bound = matc_displacement_bound(program),
                             *m = scene->objects[0].world_from_local.m;
                for (int i = 0; i < shape->vertex_count; i++) {
                    double moved[3] = {0};
                    for (int component = 0; component < 3; component++)
                        for (int row = 0; row < 3; row++)
                            moved[row] += m[4 * component + row] *
                                          ((double)shape->vertices[i].position[component] -
                                           shape->base[i][component]);
                    nearest = fmax(nearest, size_of(moved) / bound);
                    if (size_of(moved) > bound * (1 + 1e-5) + 1e-6)
                        fail_msg("%s: moves by %g, at most %g", text, size_of(moved), bound);
                }
                matc_program_free(program);
                forget(scene, document);
            }
    assert_true(nearest > .99);
    print_message("%d shapes are closed; of its bound one goes to %.3f\n", shapes, nearest);
}

/* Objects that are turned and moved share a mesh; those that are scaled do not, nor those whose
 * height goes by the world. */
static void objects_share_meshes(void **state)
{
    (void)state;
    static const struct {
        const char *material, *transform;
        int meshes;
    } cases[] = {
        {WAVE, "{ translation: [5, 0, 0] }", 1},
        {WAVE, "{ rotation: [0.1, 0.2, 0.3], translation: [5, 0, 0] }", 1},
        {WAVE, "{ scale: [2, 2, 2] }", 2},
        {"displacement: { map: Granite, input: { map: XYZTransform, useGlobal: true, transform: { "
         "scale: 1 } } }, displacementScale: 0.1",
         "{ translation: [5, 0, 0] }", 2},
        {"displacement: 0", "{ translation: [5, 0, 0] }", 0},
        {"diffuse: 1", "{ translation: [5, 0, 0] }", 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[2000];
        MatcDocument *document;
        snprintf(text, sizeof text, SCENE("%s", BALL("{ translation: [0, 0, 0] }") "\n" BALL("%s")),
                 cases[i].material, cases[i].transform);
        Scene *scene = read_scene(text, &document);
        if (scene->mesh_count != cases[i].meshes || scene->displaced != 2 * (cases[i].meshes > 0))
            fail_msg("%s: %d meshes, %d displaced", text, scene->mesh_count, scene->displaced);
        forget(scene, document);
    }
}

/* A plane has no points to displace. Too many triangles are reported. */
static void what_cannot_be_is_reported(void **state)
{
    (void)state;
    const MatcOptions by = options();
    MatcDocument *document;
    Scene *scene = read_scene(SCENE(WAVE, "- { object: Plane, material: m }"), &document);
    assert_int_equal(scene->displaced, 0);
    forget(scene, document);
    static const char refused[] =
        "materials: { m: { material: Phong, " WAVE
        " } }\ndisplacement: { triangles: 0 }\nobjects:\n- { object: Box, material: m }\n";
    document = scene_read("scene.yaml", refused, sizeof refused - 1, &by, &scene);
    assert_null(scene);
    assert_non_null(strstr(matc_diagnostics(document, MATC_TEXT), "triangles"));
    matc_document_free(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(triangles_are_divided),
        cmocka_unit_test(a_wave_moves_points_by_its_height),
        cmocka_unit_test(hard_edges_have_one_way),
        cmocka_unit_test(what_is_closed_stays_closed),
        cmocka_unit_test(hard_faces_cross_where_they_move_inward),
        cmocka_unit_test(objects_share_meshes),
        cmocka_unit_test(what_cannot_be_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
