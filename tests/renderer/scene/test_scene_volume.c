/* Volumetric displacement as triangles: closed, with the volume, holes and normals of closed
 * forms; on flat, curved, open and multi-sided bases. */
#include "runtime/tessellate/scene_displace.h"
#include "runtime/scene/scene_places.h"
#include "tests/test.h"
#include "tests/scene_whole.h"
#include "runtime/scene/scene.h"
#include "runtime/tessellate/scene_volume.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

#define SQUARE                                                                                     \
    "{ object: Parallelogram, u: [4, 0, 0], v: [0, 4, 0], material: m, transform: { translation: " \
    "[-2, -2, 0] } }"
#define BALL "= b = 1.44 - (x - 2)^2 - (y - 2)^2; h = sqrt(b); [.3 - h, .3 + h, 0, 0]"
#define HOLLOW                                                                                     \
    "= q = (x - 2)^2 + (y - 2)^2; b = 1.44 - q; i = .64 - q; h = sqrt(b); k = sqrt(i); [-h, b > "  \
    "0 ? (i > 0 ? -k : h) : -h, i > 0 ? k : 9, h]"
#define RING                                                                                       \
    "= t = .16 - (sqrt((x - 2)^2 + (y - 2)^2) - 1.1)^2; h = sqrt(t); [.5 - h, t > 0 ? .5 + h : "   \
    "-1, 0, 0]"
#define ARCH                                                                                       \
    "= a = .25 - (y - 2)^2; g = .64 - (x - 2)^2; [-.5, 0, g > 0 ? sqrt(g) : -.1, a > 0 && abs(x "  \
    "- 2) < 1.3 ? 1.2 : -1]"

static Scene *read_volume(const char *volume, const char *more, const char *object,
                          MatcDocument **document)
{
    char text[3000];
    snprintf(text, sizeof text,
             "materials: { m: { material: Phong, displacementVolume: \"%s\", displacementBound: 9 "
             "} }\ndisplacement: { %s }\nobjects:\n- %s\n",
             volume, more, object);
    return read_scene(text, document);
}

static const Shape *shape_of(const Scene *scene)
{
    return &scene->meshes[scene->objects[0].mesh].shape;
}

/* By the divergence theorem, in units of the object. */
static double volume_of(const Shape *s)
{
    double sum = 0;
    for (int i = 0; i < s->index_count; i += 3) {
        const float *a = s->vertices[s->indices[i]].position,
                    *b = s->vertices[s->indices[i + 1]].position,
                    *c = s->vertices[s->indices[i + 2]].position;
        sum += a[0] * ((double)b[1] * c[2] - (double)b[2] * c[1]) +
               a[1] * ((double)b[2] * c[0] - (double)b[0] * c[2]) +
               a[2] * ((double)b[0] * c[1] - (double)b[1] * c[0]);
    }
    return sum / 6;
}

static int by_number(const void *a, const void *b)
{
    const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

/* Corners less sides and triangles, each place once: 2 for a ball, 0 for a ring. Triangles that
 * have no width count as none. */
static int characteristic(const Shape *s)
{
    int *place = scene_places(s), corners = 0, triangles = 0;
    bool *used = calloc((size_t)s->vertex_count + 1, sizeof *used);
    uint64_t *sides = calloc((size_t)s->index_count + 1, sizeof *sides);
    size_t count = 0, different = 0;
    assert_true(place && used && sides);
    for (int i = 0; i < s->index_count; i += 3) {
        const uint64_t p[3] = {(uint64_t)place[s->indices[i]], (uint64_t)place[s->indices[i + 1]],
                               (uint64_t)place[s->indices[i + 2]]};
        if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0])
            continue;
        triangles++;
        for (int k = 0; k < 3; k++) {
            const uint64_t a = p[k], b = p[(k + 1) % 3];
            corners += !used[a];
            used[a] = true;
            sides[count++] = a < b ? a << 32 | b : b << 32 | a;
        }
    }
    qsort(sides, count, sizeof *sides, by_number);
    for (size_t i = 0; i < count; i++)
        different += !i || sides[i] != sides[i - 1];
    free(place);
    free(used);
    free(sides);
    return corners - (int)different + triangles;
}

/* Bodies, their volume, and their holes: 2 for each body, less 2 for each hole that one can look
 * through. */
static const struct {
    const char *name, *volume, *object;
    double size, within; /* its volume, and how far off it may be at 48 parts of an edge */
    int characteristic;
} bodies[] = {
    {"ball", BALL, SQUARE, 4. / 3 * 1.728, .006, 2},
    {"hollow ball", HOLLOW, SQUARE, 4. / 3 * (1.728 - .512), .012, 4},
    {"ring", RING, SQUARE, 2 * 3.14159265358979323846 * 1.1 * .16, .014, 0},
    {"slab", "= [-.25, .5, 0, 0]", SQUARE, 12 / 3.14159265358979323846, 1e-6, 2},
    {"two slabs", "= [-.25, .5, .75, 1]", SQUARE, 16 / 3.14159265358979323846, 1e-6, 4},
    {"overlapping slabs", "= [-.25, .5, .25, 1]", SQUARE, 20 / 3.14159265358979323846, 1e-6, 2},
    {"shell", "= [.1, .3, 0, 0]", "{ object: Sphere, radius: 1, detail: 60, material: m }",
     4. / 3 * (2.197 - 1.331), .004, 4},
};

static void bodies_are_closed_and_as_large_as_they_should_be(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof bodies / sizeof *bodies; i++) {
        const bool curved = strstr(bodies[i].object, "Sphere") != NULL;
        for (int half = 1; half >= 0; half--) {
            char how[50];
            MatcDocument *document;
            snprintf(how, sizeof how, "level: %d", curved ? 2 - half : 48 >> half);
            Scene *scene = read_volume(bodies[i].volume, how, bodies[i].object, &document);
            const Shape *shape = shape_of(scene);
            const double off = fabs(volume_of(shape) / (bodies[i].size * pi) - 1);
            print_message("%s, %s: %d triangles, volume off by %.5f\n", bodies[i].name, how,
                          shape->index_count / 3, off);
            assert_true(shape_body(shape) != SHAPE_BODY_none);
            assert_int_equal(characteristic(shape), bodies[i].characteristic);
            if (!half && off > bodies[i].within)
                fail_msg("%s: its volume is off by %g", bodies[i].name, off);
            forget(scene, document);
        }
    }
}

/* On the ball, as nearly as its chords can be; normals lead away from its middle. */
static void points_and_normals_are_the_balls(void **state)
{
    (void)state;
    const double scales[] = {1, .5};
    for (size_t k = 0; k < 2; k++) {
        char text[3000];
        MatcDocument *document;
        double farthest = 0, turned = 0, worst = 0;
        snprintf(text, sizeof text,
                 "materials: { m: { material: Phong, displacementVolume: \"%s\", "
                 "displacementBound: 9 } }\ndisplacement: { level: 40 }\nobjects:\n"
                 "- { object: Parallelogram, u: [4, 0, 0], v: [0, 4, 0], material: m, transform: { "
                 "rotation: [.4, .2, 1], scale: %g } }\n",
                 BALL, scales[k]);
        Scene *scene = read_scene(text, &document);
        const Shape *shape = shape_of(scene);
        assert_true(shape->vertex_count > 1000);
        /* heights are in the world, and so higher in the object's space */
        for (int i = 0; i < shape->vertex_count; i++) {
            const float *p = shape->vertices[i].position, *n = shape->vertices[i].normal;
            const double high = scales[k],
                         way[3] = {p[0] - 2., p[1] - 2., (p[2] * high - .3) * high};
            const double f = sqrt((p[0] - 2.) * (p[0] - 2.) + (p[1] - 2.) * (p[1] - 2.) +
                                  (p[2] * high - .3) * (p[2] * high - .3));
            const double size = sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
            const double angle =
                acos(fmin(1, (way[0] * n[0] + way[1] * n[1] + way[2] * n[2]) / size));
            farthest = fmax(farthest, fabs(f - 1.2));
            turned += angle * angle;
            worst = fmax(worst, angle);
        }
        turned = sqrt(turned / shape->vertex_count);
        print_message("scale %g: %d points off by %.2g at most; normals by %.4f in the mean "
                      "square, %.3f at most\n",
                      scales[k], shape->vertex_count, farthest, turned, worst);
        assert_true(farthest < 1e-4 && turned < .01);
        forget(scene, document);
    }
}

/* How often a ray meets triangles. */
static int meets(const Shape *s, const double from[3], const double way[3])
{
    int count = 0;
    for (int i = 0; i < s->index_count; i += 3) {
        const float *p[3];
        double side[3];
        for (int k = 0; k < 3; k++)
            p[k] = s->vertices[s->indices[i + k]].position;
        for (int k = 0; k < 3; k++) { /* six times the volume between the ray and an edge */
            double a[3], b[3];
            for (int component = 0; component < 3; component++) {
                a[component] = p[k][component] - from[component];
                b[component] = p[(k + 1) % 3][component] - from[component];
            }
            side[k] = way[0] * (a[1] * b[2] - a[2] * b[1]) + way[1] * (a[2] * b[0] - a[0] * b[2]) +
                      way[2] * (a[0] * b[1] - a[1] * b[0]);
        }
        count += (side[0] > 0 && side[1] > 0 && side[2] > 0) ||
                 (side[0] < 0 && side[1] < 0 && side[2] < 0);
    }
    return count;
}

/* An arch on a plain: light passes under it, and nowhere through its sides; a pillar's ray enters
 * and leaves. */
static void light_passes_under_an_arch(void **state)
{
    (void)state;
    MatcDocument *document;
    Scene *scene = read_volume(ARCH, "triangles: 12000", SQUARE, &document);
    const Shape *shape = shape_of(scene);
    assert_int_equal(characteristic(shape), 0);
    assert_true(abs(shape->index_count / 3 - 12000) < 3000);
    int seen = 0, hidden = 0;
    for (int i = 0; i < 40; i++)
        for (int k = 1; k < 20; k++) {
            const double x = .5013 + i * .0767, z = k * .0637;
            const double gate = .64 - (x - 2) * (x - 2);
            const bool solid = fabs(x - 2) < 1.3 && z < 1.2 && (gate <= 0 || z > sqrt(gate));
            const double nearest = fmin(fmin(fabs(fabs(x - 2) - 1.3), fabs(z - 1.2)),
                                        fabs(sqrt((x - 2) * (x - 2) + z * z) - .8));
            if (nearest < .1)
                continue;
            if (meets(shape, (double[3]){x, -1, z}, (double[3]){0, 1, 0}) != (solid ? 2 : 0))
                fail_msg("at %g %g", x, z);
            seen += !solid && gate > 0 && z < .7;
            hidden += solid;
        }
    print_message("%d rays pass under it, %d do not through it\n", seen, hidden);
    assert_true(seen > 60 && hidden > 60);
    forget(scene, document);
}

/* Parts that begin below the threshold are missing; without it, they are there. A shape depends on
 * a param, for each of several objects alike. */
static void thresholds_and_changes(void **state)
{
    (void)state;
    MatcDocument *document;
    const double size = 16;
    for (int with = 0; with < 2; with++) {
        char text[1000];
        snprintf(text, sizeof text,
                 "materials: { m: { material: Phong, displacementVolume: { param: heights, "
                 "default: [0.05, 0.3, 0.5, 0.75] }, displacementBound: 9%s } }\n"
                 "displacement: { level: 6 }\nobjects:\n- %s\n- { object: Box, size: [1, 1, 1], "
                 "material: m }\n",
                 with ? ", displacementThreshold: 0.1" : "", SQUARE);
        Scene *scene = read_scene(text, &document);
        assert_int_equal(scene->displaced, 2);
        const double is = volume_of(shape_of(scene));
        assert_true(fabs(is - size * (with ? .25 : .5)) < 1e-4);
        assert_true(shape_body(&scene->meshes[scene->objects[1].mesh].shape) != SHAPE_BODY_none);
        assert_int_equal(scene_displace_param(scene, 0, "heights", (double[]){.05, .3, .5, 1.5}, 4),
                         SCENE_DISPLACED_rebuilt);
        assert_true(fabs(volume_of(shape_of(scene)) - is - size * .75) < 1e-4);
        assert_int_equal(scene_displace_param(scene, 0, "heights", (double[]){.05, .3, .5, .25}, 4),
                         SCENE_DISPLACED_rebuilt);
        assert_true(fabs(volume_of(shape_of(scene)) - (with ? 0 : size * .25)) < 1e-4);
        forget(scene, document);
    }
}

typedef struct {
    bool cliff;
    int asked;
} Asked;

/* A ball of radius 1.2 around (2, 2, 0), or a slab as high as 1 that ends at x = 1.2345. */
static bool solid_there(void *user, SceneColumn *columns, int count)
{
    Asked *asked = user;
    asked->asked += count;
    for (int i = 0; i < count; i++) {
        const double x = (double)columns[i].at.position[0] - 2,
                     y = (double)columns[i].at.position[1] - 2;
        const double high = sqrt(fmax(1.44 - x * x - y * y, 0)),
                     top = asked->cliff ? x < -.7655 : high;
        const double heights[4] = {asked->cliff ? 0 : -high, top, 0, 0}, along[3] = {0, 0, 1};
        memcpy(columns[i].heights, heights, sizeof heights);
        memcpy(columns[i].along, along, sizeof along);
    }
    return true;
}

/* For smooth heights a surface point requests three or four columns along its edge, and four
 * around it; at a cliff all points above an edge are found together. */
static void few_columns_are_asked_for(void **state)
{
    (void)state;
    ShapeVertex corners[4] = {0};
    uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
    for (int i = 0; i < 4; i++) {
        corners[i].position[0] = corners[i].tangentU[0] = i == 1 || i == 2 ? 4 : 0;
        corners[i].position[1] = i >= 2 ? 4 : 0;
        corners[i].normal[2] = 1;
    }
    const Shape square = {
        .vertices = corners, .indices = indices, .vertex_count = 4, .index_count = 6};
    for (int cliff = 0; cliff < 2; cliff++) {
        Asked asked = {.cliff = cliff};
        Shape made;
        double off = 0, steps[2];
        int wall = 0;
        assert_true(
            scene_volume(&square, &(SceneVolume){solid_there, &asked, 50, 0}, &made, steps));
        assert_true(fabs(steps[0] - .08 * (2 + sqrt(2)) / 3) < 1e-9 && steps[1] <= steps[0] &&
                    steps[1] > 0);
        for (int i = 0; i < made.vertex_count; i++) {
            const float *p = made.vertices[i].position;
            const double x = (double)p[0] - 2, y = (double)p[1] - 2, z = (double)p[2];
            const bool at_cliff =
                cliff && z > .01 && z < .99 && p[0] > .01f && p[1] > .01f && p[1] < 3.99f;
            off = fmax(off, cliff ? (at_cliff ? fabs(x + .7655) : 0)
                                  : fabs(sqrt(x * x + y * y + z * z) - 1.2));
            wall += at_cliff;
        }
        print_message("%s: %d points, %.2f columns for each, %.2g off\n",
                      cliff ? "a cliff" : "a ball", made.vertex_count,
                      (double)asked.asked / made.vertex_count, off);
        assert_true(asked.asked < (cliff ? 3 : 9) * made.vertex_count);
        assert_true(off < (cliff ? .08 / 1024 : 1e-4) && (!cliff || wall > 500));
        shape_free(&made);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(few_columns_are_asked_for),
        cmocka_unit_test(bodies_are_closed_and_as_large_as_they_should_be),
        cmocka_unit_test(points_and_normals_are_the_balls),
        cmocka_unit_test(light_passes_under_an_arch), cmocka_unit_test(thresholds_and_changes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
