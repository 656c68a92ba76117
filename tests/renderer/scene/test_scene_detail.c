/* Level of detail by size in the picture: outlines of solids with fewer sides, by projections
 * written down here; meshes that displaced copies share, against the same points displaced
 * individually; which scenes use detail; the warning about a scene of too many triangles. */
#include "runtime/tessellate/scene_displace.h"
#include "runtime/tessellate/scene_solid.h"
#include "tests/scene_text.h"
#include "compiler/matc.h"
#include "runtime/scene/scene_detail.h"
#include "runtime/tessellate/scene_displacement.h"
#include "runtime/scene/scene_matrix.h"
#include <stdlib.h>

static const double allowed = .125; /* pixels */

/* The greatest distance of a face from the solid that it approximates: for a sphere that of its
 * triangles' planes. */
static double sagitta(const SceneObject *object)
{
    Shape shape;
    double most = 0;
    assert_true(scene_solid(object, &shape));
    for (int i = 0; i < shape.index_count; i += 3) {
        double at[3][3], u[3], v[3], n[3];
        for (int k = 0; k < 9; k++)
            at[k / 3][k % 3] = (double)shape.vertices[shape.indices[i + k / 3]].position[k % 3];
        for (int k = 0; k < 3; k++)
            u[k] = at[1][k] - at[0][k], v[k] = at[2][k] - at[0][k];
        vec3_cross(u, v, n);
        if (object->kind == SCENE_Sphere && vec3_normalize(n))
            most = fmax(most, 1 - fabs(vec3_dot(n, at[0])));
        /* edges between two points of the rim */
        for (int k = 0; object->kind != SCENE_Sphere && k < 3; k++)
            if (fabs(hypot(at[k][0], at[k][1]) - 1) < 1e-5 &&
                fabs(hypot(at[(k + 1) % 3][0], at[(k + 1) % 3][1]) - 1) < 1e-5)
                most = fmax(
                    most,
                    1 - hypot(at[k][0] + at[(k + 1) % 3][0], at[k][1] + at[(k + 1) % 3][1]) / 2);
    }
    shape_free(&shape);
    return most;
}

static void sides_are_off_by_an_eighth_of_a_pixel(void **state)
{
    (void)state;
    static const SceneKind kinds[] = {SCENE_Sphere, SCENE_Cylinder, SCENE_Cone};
    for (int k = 0; k < 3; k++) {
        int before = 0;
        for (double pixels = .01; pixels < 1e4; pixels *= 1.1) {
            const int steps = scene_detail_steps(kinds[k], pixels);
            SceneObject object = {.kind = kinds[k], .numbers = {1, 1, 1}};
            object.numbers[kinds[k] == SCENE_Sphere ? 1 : 2] = steps;
            assert_true(steps >= before && steps <= 192 && steps >= 12 && 192 % steps == 0);
            if (steps < 192 && sagitta(&object) * pixels > allowed + 1e-4)
                fail_msg("kind %d, %g pixels: %d steps are off by %g", (int)kinds[k], pixels, steps,
                         sagitta(&object) * pixels);
            before = steps;
        }
        assert_int_equal(before, 192);
    }
    assert_int_equal(scene_detail_steps(SCENE_Sphere, INFINITY), 192);
}

/* A point of the world in the picture, in pixels from its middle; false: it is not there. */
static bool project(const SceneCamera *c, const Scene *scene, const double at[3], double pixel[2])
{
    double way[3];
    for (int i = 0; i < 3; i++)
        way[i] = at[i] - c->position[i];
    const double shorter = fmin(scene->width, scene->height), depth = -vec3_dot(way, c->back);
    const double scale = shorter / 2 / c->half / (c->kind == SCENE_Perspective ? depth : 1);
    pixel[0] = scale * vec3_dot(way, c->right);
    pixel[1] = scale * vec3_dot(way, c->up);
    return depth > c->near && fabs(pixel[0]) < scene->width / 2. &&
           fabs(pixel[1]) < scene->height / 2.;
}

/* Intersection of a light's ray through a point with the ground, z = 0; false if there is no
 * intersection. */
static bool cast(const SceneLight *light, const double at[3], double to[3])
{
    double way[3];
    for (int i = 0; i < 3; i++)
        way[i] =
            light->kind == SCENE_Directional ? light->direction[i] : at[i] - light->position[i];
    if (way[2] >= 0 || at[2] < 0)
        return false;
    for (int i = 0; i < 3; i++)
        to[i] = at[i] - way[i] * at[2] / way[2];
    return true;
}

typedef struct {
    double direct, shadow; /* the greatest error in pixels */
    long compared;
} Off;

static double apart(const SceneCamera *camera, const Scene *scene, const double a[3],
                    const double b[3], Off *off)
{
    double p[2], q[2];
    if (!project(camera, scene, a, p) || !project(camera, scene, b, q))
        return 0;
    off->compared++;
    return hypot(p[0] - q[0], p[1] - q[1]);
}

/* The point nearest to `at` of a light's ray through `by`: how far a shadow's border is off is
 * measured across the rays, since on ground that they graze a shadow is as much longer as it is
 * itself. */
static void across(const SceneLight *light, const double by[3], const double at[3], double near[3])
{
    double way[3], from[3];
    for (int i = 0; i < 3; i++) {
        way[i] =
            light->kind == SCENE_Directional ? light->direction[i] : by[i] - light->position[i];
        from[i] = at[i] - by[i];
    }
    const double t = vec3_dot(way, from) / vec3_dot(way, way);
    for (int i = 0; i < 3; i++)
        near[i] = by[i] + t * way[i];
}

/* The middle of a chord against the middle of its arc, around the foot and around the top. */
static void compare(const Scene *scene, const SceneCamera *camera, const SceneObject *object,
                    Off *off)
{
    const double steps = object->numbers[scene_detail_number(object->kind)], r = object->numbers[0];
    for (int i = 0; i < 2 * 8; i++) {
        const double turn = 3.14159265358979323846 * (2 * i + 1) / steps,
                     inner = r * cos(3.14159265358979323846 / steps),
                     z = i % 2 && object->kind == SCENE_Cylinder ? object->numbers[1] : 0;
        double arc[3], chord[3], arcs[3], chords[3];
        apply(&object->world_from_local, (double[]){r * cos(turn), r * sin(turn), z}, arc);
        apply(&object->world_from_local, (double[]){inner * cos(turn), inner * sin(turn), z},
              chord);
        off->direct = fmax(off->direct, apart(camera, scene, arc, chord, off));
        for (int k = 0; k < scene->light_count; k++)
            if (cast(&scene->lights[k], arc, arcs)) {
                across(&scene->lights[k], chord, arcs, chords);
                off->shadow = fmax(off->shadow, apart(camera, scene, arcs, chords, off));
            }
    }
}

#define STAND                                                                                      \
    "materials: { m: { material: RGBA } }\nimage: { width: 640, height: 360 }\n"                   \
    "lights:\n- { light: Directional, direction: [1, .3, -.4] }\n- { light: Point, position: [0, " \
    "3, 6] }\n"
#define TRUNKS                                                                                     \
    "objects:\n- { object: Scatter, count: 1500, least: .3, most: 3, rotation: [1, 1, 3], size: "  \
    "[120, 120, 4], "                                                                              \
    "transform: { "                                                                                \
    "translation: [0, 0, 3] }, objects: [{ object: Cylinder, radius: .2, height: 1, material: m "  \
    "}, { object: Sphere, "                                                                        \
    "radius: "                                                                                     \
    ".3, material: m }, { object: Cone, radius: .3, height: 1, material: m, detail: 100 }] }\n"

static const char *const cameras[] = {
    "camera: { camera: Perspective, position: [0, -30, 8], target: [0, 0, 1], angle: 60 }\n",
    "camera: { camera: Perspective, position: [0, -30, 8], target: [0, 0, 1], angle: 100 "
    "}\nmotion: { motion: Path, "
    "frames: 60, keys: [{ "
    "time: 0, position: [0, -60, 8] }, { time: 1, position: [9, 0, 2] }, { time: 2, position: [40, "
    "30, 9] }] }\n",
    "camera: { camera: Perspective, position: [30, 0, 8], target: [0, 0, 1], angle: 40 }\nmotion: "
    "{ motion: Turntable, "
    "frames: 40 }\n",
    "camera: { camera: Orthographic, position: [0, -90, 40], target: [0, 0, 0], size: 90, depth: "
    "400 }\n"};

/* Also in every frame of a camera that moves through the solids; each step count occurs. */
static void outlines_and_shadows_are_right(void **state)
{
    (void)state;
    for (int i = 0; i < 4; i++) {
        char text[2048];
        MatcDocument *document;
        int levels = 0;
        Off off = {0};
        snprintf(text, sizeof text, "%s%s%s", cameras[i], STAND, TRUNKS);
        Scene *scene =
            /* a path through all of it leaves many triangles, of which it warns */
            read_text(text, &document);
        assert_non_null(scene);
        for (int k = 0; k < scene->object_count; k++) {
            const SceneObject *object = &scene->objects[k];
            const int steps = (int)object->numbers[scene_detail_number(object->kind)];
            if (object->kind == SCENE_Cone)
                assert_int_equal(steps, 100); /* it is given */
            if (object->kind != SCENE_Cylinder || steps == 192)
                continue;
            levels |= steps;
            const int frames = scene->motion.frames ? scene->motion.frames : 1;
            for (int frame = 0; frame < frames; frame++) {
                SceneCamera camera = scene->camera;
                if (scene->motion.frames)
                    assert_true(scene_motion_camera(scene, frame, frames, &camera));
                compare(scene, &camera, object, &off);
            }
        }
        fprintf(stderr, "camera %d: levels %x, off by %.4f, in shadows by %.4f pixels, of %ld\n", i,
                (unsigned)levels, off.direct, off.shadow, off.compared);
        if (i < 3) {
            assert_true((levels & 12) && (levels & 16) && off.compared > 1000);
            assert_true(off.direct > allowed / 16); /* not all are finer than they need be */
        } else
            assert_int_equal(levels, 0); /* a lamp's shadows may fill the picture */
        assert_true(off.direct <= allowed && off.shadow <= allowed);
        forget(scene, document);
    }
}

static void small_scenes_are_as_they_are_written(void **state)
{
    (void)state;
    static const char text[] = STAND "objects:\n- { object: Scatter, count: 14, size: [1, 1, 1], "
                                     "objects: [{ object: Sphere, material: "
                                     "m, transform: { translation: [0, 1000, 0] } }] }\n";
    MatcDocument *document;
    Scene *scene = read_fine(text, &document);
    for (int i = 0; i < scene->object_count; i++)
        assert_int_equal((int)scene->objects[i].numbers[1], 192);
    forget(scene, document);
}

/* A larger picture than the scene's own wants more steps, the same the same ones. */
static void larger_pictures_are_finer(void **state)
{
    (void)state;
    MatcDocument *document;
    char text[2048];
    snprintf(text, sizeof text, "%s%s%s", cameras[0], STAND, TRUNKS);
    Scene *scene = read_fine(text, &document);
    double before = 0, larger = 0, again = 0;
    for (int i = 0; i < scene->object_count; i++)
        before += scene->objects[i].numbers[scene_detail_number(scene->objects[i].kind)];
    scene_displace_resized(scene, 6400, 3600);
    for (int i = 0; i < scene->object_count; i++)
        larger += scene->objects[i].numbers[scene_detail_number(scene->objects[i].kind)];
    scene_displace_resized(scene, 640, 360);
    for (int i = 0; i < scene->object_count; i++)
        again += scene->objects[i].numbers[scene_detail_number(scene->objects[i].kind)];
    assert_true(larger > 1.5 * before && again == before);
    forget(scene, document);
}

/* The greatest distance of a mesh's vertices from where its object's own size leads them, in
 * pixels. */
static double off_of(const Scene *scene, const SceneObject *object)
{
    const Shape *shape = &scene->meshes[object->mesh].shape;
    const SceneMaterial *of = &scene->materials[object->material];
    const SceneMatrix *m = &object->world_from_local;
    SceneMatrix inverse;
    MatcOptions options;
    double most = 0;
    matc_options_init(&options);
    assert_true(scene_matrix_invert(m, &inverse) && shape->base);
    for (int i = 0; i < shape->vertex_count; i += 7) {
        ShapeVertex vertex = shape->vertices[i];
        double there[3], way[3], local[3];
        for (int k = 0; k < 3; k++)
            local[k] = (double)vertex.position[k];
        memcpy(vertex.position, shape->base[i], sizeof vertex.position);
        MatcPoint point = scene_displaced_point(&vertex, m, &inverse, scene->origin);
        assert_true(matc_move(of->document, of->index, &options, &point, 1));
        apply(m, local, there);
        double distance = 0;
        for (int k = 0; k < 3; k++) {
            distance +=
                (there[k] - scene->camera.position[k]) * (there[k] - scene->camera.position[k]);
            way[k] = there[k] - point.position[k];
        }
        const double shorter = fmin(scene->width, scene->height);
        most = fmax(most, sqrt(vec3_dot(way, way) / distance) * shorter / 2 / scene->camera.half);
    }
    return most;
}

#define ROCKS(camera, image, height)                                                               \
    "image: " image "\ncamera: { camera: Perspective, position: " camera                           \
    " }\nobjects:\n- { object: Scatter, count: 40, size: "                                         \
    "[6, 6, 0], least: 0.7, most: 1.5, objects: [{ object: Sphere, radius: .4, material: { "       \
    "material: Phong, "                                                                            \
    "displacement: \"" height                                                                      \
    "\" } }] }\nlights: [{ light: Directional, direction: [0, 0, -1] }]\n"

static void displaced_copies_share_meshes(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int most_meshes;
        int64_t most_triangles;
    } cases[] = {
        {ROCKS("[0, -9, 4]", "{ width: 64, height: 64 }", "= .1 * fbm(3 * p, 4)"), 30, 40000},
        {ROCKS("[0, -90, 40]", "{ width: 64, height: 64 }", "= .1 * fbm(3 * p, 4)"), 4, 40000},
        {ROCKS("[0, -9, 4]", "{ width: 640, height: 640 }", "= .1 * fbm(3 * p, 4)"), 40, 2500000},
        {ROCKS("[0, -9, 4]", "{ width: 64, height: 64 }", "= .1 * fbm(3 * p, 4) + .01 * sin(P.x)"),
         40, 40000},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        MatcDocument *document;
        Scene *scene = read_fine(cases[i].text, &document);
        int64_t triangles = 0;
        double most = 0;
        for (int k = 0; k < scene->object_count; k++) {
            triangles += scene->meshes[scene->objects[k].mesh].shape.index_count / 3;
            most = fmax(most, i < 3 ? off_of(scene, &scene->objects[k]) : 0);
        }
        fprintf(stderr, "%zu: %d meshes, %lld triangles, off by %.4f pixels\n", i,
                scene->mesh_count, (long long)triangles, most);
        assert_true(scene->mesh_count <= cases[i].most_meshes &&
                    triangles <= cases[i].most_triangles);
        assert_true(most <= allowed);
        assert_true(i != 1 || most > 0);
        assert_true(i != 3 || scene->mesh_count == 40); /* a height of each copy's own */
        forget(scene, document);
    }
}

static void many_triangles_are_reported(void **state)
{
    (void)state;
    static const char balls[] = "materials: { m: { material: RGBA } }\nlights: [{ light: Point "
                                "}]\nobjects:\n- { object: Box, material: m }\n"
                                "- { object: Scatter, count: %d, size: [9, 9, 9], objects: [{ "
                                "object: Sphere, detail: 192, material: m }] }\n";
    char text[512];
    MatcDocument *document;
    snprintf(text, sizeof text, balls, 135); /* of 36,864 triangles each */
    Scene *scene = read_fine(text, &document);
    forget(scene, document);
    snprintf(text, sizeof text, balls, 136);
    scene = read_text(text, &document);
    assert_non_null(scene);
    assert_int_equal(matc_error_count(document), 0);
    const char *wanted =
        "scene.yaml:5:61: warning: the scene has 5013516 triangles, 5013504 of them "
        "in this Sphere and "
        "its copies, 136 in all; ";
    const char *reported = matc_diagnostics(document, MATC_TEXT);
    if (strncmp(reported, wanted, strlen(wanted)) != 0)
        fail_msg("%s", reported);
    forget(scene, document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sides_are_off_by_an_eighth_of_a_pixel),
        cmocka_unit_test(outlines_and_shadows_are_right),
        cmocka_unit_test(small_scenes_are_as_they_are_written),
        cmocka_unit_test(larger_pictures_are_finer),
        cmocka_unit_test(displaced_copies_share_meshes),
        cmocka_unit_test(many_triangles_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
