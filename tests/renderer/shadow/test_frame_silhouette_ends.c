/* Silhouette shadow boundaries by closed forms: several edges that cross one segment between
 * texels, an edge hidden below the ground, an edge along texel centers, and normals that differ
 * from the surface's. */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/shadow_ray.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 120, HEIGHT = 90, PIXELS = WIDTH * HEIGHT, SIZE = 256 };

/* The ground, to which a map for light from straight above is fitted: it has 2 (filter + 2) texels
 * more. */
#define GROUND_EDGE 1.5
static const double TEXEL = GROUND_EDGE * (1 + 6.0 / SIZE) / SIZE;

/* A box of a height in the air, half an edge of which is so many texels; turned around the z
 * axis. */
typedef struct {
    double middle, half, turned;
} Caster;

typedef struct {
    const char *name;
    Caster casters[2];
    double end, slope; /* of the shadow along x, in texels, and how that changes along y */
    double lean;       /* of the ground's normals, in degrees, along y */
} Case;

/* Centers of texels are at 83.5, 84.5, ... from the middle. */
static const Case cases[] = {
    {"one edge", {{.9, 83.8, 0}}, 83.8, 0, 0},
    {"two edges on a segment, the upper one farther", {{.9, 84.2, 0}, {.4, 83.7, 0}}, 84.2, 0, 0},
    {"two edges on a segment, the lower one farther", {{.9, 83.7, 0}, {.4, 84.2, 0}}, 84.2, 0, 0},
    {"an edge below the ground", {{.9, 83.7, 0}, {-.4, 84.2, 0}}, 83.7, 0, 0},
    {"along centres", {{.9, 83.5, 1.3e-3}}, 83.5, -1.3e-3, 0},
    {"before centres", {{.9, 83.4985, 0}}, 83.4985, 0, 0},
    {"behind centres", {{.9, 83.5015, 0}}, 83.5015, 0, 0},
    {"leaning normals", {{.9, 83.8, 0}}, 83.8, 0, 15},
};

static void put_scene(const Case *c, char *text, size_t size)
{
    int length = snprintf(
        text, size,
        "image: { width: 120, height: 90 }\ncamera: { camera: Perspective, position: [3, 0, 1], "
        "target: [%.9f, 0, 0], angle: 1.2 }\nmaterials: { m: { material: Phong, diffuse: .5 } }\n"
        "lights: [{ light: Directional, shadows: silhouette }]\nshadowMaps: { size: 256 "
        "}\nobjects:\n"
        "- { object: Parallelogram, u: [1.5, 0, 0], v: [0, 1.5, 0], material: m, transform: { "
        "translation: [-.75, -.75, 0] } }\n",
        c->end * TEXEL);
    for (int i = 0; i < 2 && c->casters[i].half > 0; i++)
        length += snprintf(text + length, size - (size_t)length,
                           "- { object: Box, size: [%.9f, %.9f, .1], material: m, transform: { "
                           "translation: [0, 0, "
                           "%g], rotation: [0, 0, %.9f] } }\n",
                           2 * c->casters[i].half * TEXEL, 2 * c->casters[i].half * TEXEL,
                           c->casters[i].middle, c->casters[i].turned);
}

/* The ground as a mesh with leaning normals, as by a bump map. */
static void lean_ground(Scene *scene, double lean, ShapeVertex vertices[4], SceneMesh *mesh)
{
    static uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
    for (int i = 0; i < 4; i++)
        vertices[i] =
            (ShapeVertex){.position = {i == 1 || i == 2 ? GROUND_EDGE : 0, i > 1 ? GROUND_EDGE : 0},
                          .normal = {0, (float)sin(lean), (float)cos(lean)}};
    mesh->shape =
        (Shape){.vertices = vertices, .indices = indices, .vertex_count = 4, .index_count = 6};
    scene->meshes = mesh;
    scene->mesh_count = 1;
    scene->objects[0].kind = SCENE_Mesh;
    scene->objects[0].mesh = 0;
}

/* No pixel is wrong that is more than 1/50 texel from the end. */
static void end_is_true(GlContext *gl, const Case *c)
{
    const MatcOptions options = frame_exact_options();
    char text[2048];
    MatcDocument *document;
    int wrong = 0, dark = 0;
    put_scene(c, text, sizeof text);
    Scene *scene = frame_scene(text, &options, &document);
    ShapeVertex vertices[4];
    SceneMesh mesh = {0};
    if (c->lean > 0)
        lean_ground(scene, c->lean * PI / 180, vertices, &mesh);
    float *light =
        frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
    Tracer tracer = reference_open(scene);
    for (int i = 0; i < PIXELS; i++) {
        const Ray ray = reference_ray(scene, i % WIDTH + .5, i / WIDTH + .5);
        const Hit hit = reference_hit(&tracer, &ray, 0);
        const double end = c->end * TEXEL + c->slope * hit.world[1];
        const bool lit = light[4 * i] > 1e-3f;
        assert_int_equal(hit.object, 0);
        dark += !lit;
        wrong += fabs(hit.world[0] - end) > .02 * TEXEL && lit != (hit.world[0] > end);
    }
    print_message("%s: %d dark, %d wrong\n", c->name, dark, wrong);
    assert_true(dark > PIXELS / 4 && dark < PIXELS * 3 / 4);
    assert_int_equal(wrong, 0);
    reference_close(&tracer);
    free(light);
    scene->mesh_count = 0; /* it is not the scene's */
    frame_forget(scene, document);
}

static void ends(void **state)
{
    (void)state;
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        end_is_true(gl, &cases[i]);
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(ends)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
