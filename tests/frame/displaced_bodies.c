/* Displaced meshes, and views of them. */
#include "tests/frame/displaced_bodies.h"
#include "tests/frame/frame_compare.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { SQUARE = 3 };

static const char materials[] =
    "  rock: { material: Phong, diffuse: 0.6, emissive: 0.2, displacementScale: 0.2, "
    "displacementBound: 0.3, "
    "displacement: { map: VolumeTurbulence, size: 2, octaves: 3, noiseRatio: 0.5 } }\n"
    "  tiles: { material: Phong, diffuse: [0.7, 0.4, 0.2], emissive: 0.2, displacementScale: 0.1, "
    "displacement: { map: "
    "Checker, input: { map: UVTransform, scaleU: 5.3, scaleV: 4.1 } } }\n"
    "  still: { material: Phong, diffuse: 0.6, emissive: 0.2, displacementScale: 1e-6, "
    "displacement: { map: Gradient, "
    "direction: [3, 5, 2], waveForm: Sin } }\n"
    "  leaning: { material: Phong, diffuse: 0.8, emissive: 0.2, displacementVector: { map: Blend, "
    "input: { map: "
    "Gradient, direction: [2, 3, 1], waveForm: Sin },\n"
    "    blend: [{ value: -1, input: [0.1, 0, -0.1] }, { value: 1, input: [-0.1, 0.1, 0.2] }] } "
    "}\n";
static const char *const bodies[DISPLACED_BODIES] = {
    "{ object: Box, size: [1.4, 1.4, 1.4], material: rock, transform: { rotation: [0.3, 0.5, 0.1] "
    "} }",
    "{ object: Sphere, radius: 0.9, material: tiles, detail: 12 }",
    "{ object: Cylinder, radius: 0.6, height: 1.2, detail: 12, material: leaning, transform: { "
    "translation: [0, 0, "
    "-0.6] } }",
    "{ object: Parallelogram, u: [2, 0, 0], v: [0, 2, 0], material: rock, transform: { "
    "translation: [-1, -1, 0] } }",
    "{ object: Box, size: [2, 2, 2], material: still }"};

Scene *displaced_body(int body, const char *how, const MatcOptions *options,
                      MatcDocument **document)
{
    char text[4000];
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [1, -3, "
             "2], angle: 40 "
             "}\nmaterials:\n%s"
             "displacement: { %s }\nlights: []\nobjects:\n- %s\n",
             DISPLACED_EDGE, DISPLACED_EDGE, materials, how, bodies[body]);
    return frame_scene(text, options, document);
}

Scene *displaced_drawn(GlContext *gl, int body, const char *how, MatcDocument **document)
{
    /* a draw call captures the triangles */
    const MatcOptions options = frame_exact_options();
    Scene *scene = displaced_body(body, how, &options, document);
    free(frame_floats(gl, scene,
                      &(RendererOptions){
                          .compile = &options, .view = "light", .edges = RENDERER_EDGES_coverage}));
    return scene;
}

static void look_from(Scene *scene, int body, int view)
{
    const int views = DISPLACED_VIEWS;
    const bool above = body == SQUARE;
    const double z = above ? .5 + .4 * view / views : 1 - (2 * view + 1.) / views,
                 turn = 2.399963229728653 * view, r = sqrt(1 - z * z), distance = 1.7,
                 way[3] = {r * cos(turn), r * sin(turn), z};
    for (int i = 0; i < 3; i++)
        scene->camera.position[i] = distance * way[i];
    assert_true(scene_camera_aim(&scene->camera) == SCENE_AIM_fine);
}

void displaced_draw_views(GlContext *gl, int body, const char *how, float *light)
{
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = displaced_body(body, how, &options, &document);
    Renderer *renderer =
        renderer_open(gl, &(RendererOptions){.compile = &options, .view = "light"});
    assert_true(renderer && renderer_set_scene(renderer, scene));
    for (int view = 0; view < DISPLACED_VIEWS; view++) {
        look_from(scene, body, view);
        assert_true(renderer_changed(renderer, RENDERER_CAMERA) && renderer_frame(renderer) &&
                    renderer_read(renderer, light + view * DISPLACED_VIEW_FLOATS));
    }
    renderer_close(renderer);
    frame_forget(scene, document);
}

static double apart(const float a[3], const float b[3])
{
    double sum = 0;
    for (int i = 0; i < 3; i++)
        sum += ((double)a[i] - (double)b[i]) * ((double)a[i] - (double)b[i]);
    return sqrt(sum);
}

double displaced_nearest(const Shape *shape, const float position[3], const float base[3])
{
    double least = INFINITY;
    for (int i = 0; i < shape->vertex_count; i++)
        if (apart(shape->base[i], base) < 1e-5)
            least = fmin(least, apart(shape->vertices[i].position, position));
    return least;
}

static bool shown(const float *light, int x, int y)
{
    return light[4 * (y * DISPLACED_EDGE + x)] > .1f;
}

/* Two pixels from the outline, because coarse triangles have another outline. */
int displaced_holes(const float *light, const float *whole, long *within)
{
    enum { AWAY = 2, SIDE = 2 * AWAY + 1 };
    int count = 0;
    for (int y = AWAY; y < DISPLACED_EDGE - AWAY; y++)
        for (int x = AWAY; x < DISPLACED_EDGE - AWAY; x++) {
            int around = 0;
            for (int i = 0; i < SIDE * SIDE; i++)
                around += shown(whole, x + i % SIDE - AWAY, y + i / SIDE - AWAY);
            *within += shown(light, x, y);
            count += around == SIDE * SIDE && !shown(light, x, y);
        }
    return count;
}

int displaced_holes_of(GlContext *gl, const int bodies[2], const char *how, long *within)
{
    static float light[DISPLACED_VIEWS * DISPLACED_VIEW_FLOATS],
        whole[DISPLACED_VIEWS * DISPLACED_VIEW_FLOATS];
    int count = 0;
    for (int body = 0; body < 2; body++) {
        displaced_draw_views(gl, bodies[body], "method: mesh, level: 40", whole);
        displaced_draw_views(gl, bodies[body], how, light);
        for (int at = 0; at < DISPLACED_VIEWS * DISPLACED_VIEW_FLOATS; at += DISPLACED_VIEW_FLOATS)
            count += displaced_holes(light + at, whole + at, within);
    }
    return count;
}
