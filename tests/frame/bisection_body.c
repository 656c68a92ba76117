/* Runs bisection by compute stages for tests. */
#include "tests/frame/bisection_body.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EDGE = BISECTION_BODY_EDGE };

const char bisection_body_materials[] =
    "materials:\n"
    "  rock: { material: Phong, diffuse: 0.6, emissive: 0.2, displacementScale: 0.2,\n"
    "    displacementBound: 0.3, displacement: { map: VolumeTurbulence, size: 2, octaves: 3, "
    "noiseRatio: 0.5 } }\n"
    "  tiles: { material: Phong, diffuse: [0.7, 0.4, 0.2], emissive: 0.2, displacementScale: 0.1,\n"
    "    displacement: { map: Checker, input: { map: UVTransform, scaleU: 5.3, scaleV: 4.1 } } }\n";
const char *const bisection_bodies[BISECTION_BODIES] = {
    "- { object: Parallelogram, u: [6,0,0], v: [1,5,.5], material: rock, transform: { translation: "
    "[-3,-2,0] } }\n",
    "- { object: Sphere, radius: 0.9, material: rock, detail: 8 }\n",
    "- { object: Box, size: [1.4, 1.4, 1.4], material: rock, transform: { rotation: [0.3, 0.5, "
    "0.1] } }\n",
    "- { object: Sphere, radius: 0.9, material: tiles, detail: 12 }\n",
    "- { object: Cone, radius: 0.8, height: 1.5, detail: 12, material: rock, transform: { "
    "translation: [0, 0, -0.5], "
    "rotation: [2, 0, 0], scale: [1, 1.2, 0.8] } }\n",
};

Scene *bisection_body_scene(const char *how, const char *object, const MatcOptions *options,
                            MatcDocument **document)
{
    char text[4000];
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [1, -3, "
             "2], angle: 40 }\n%s"
             "displacement: { method: bisection, %s }\nlights: [{ light: Directional, direction: "
             "[1,.6,-1] }]\nobjects:\n%s",
             EDGE, EDGE, bisection_body_materials, how, object);
    return frame_scene(text, options, document);
}

void bisection_body_look(SceneCamera *camera, int view, int views, double distance)
{
    const double z = 1 - (2 * view + 1.) / views, turn = 2.399963229728653 * view,
                 r = sqrt(1 - z * z), way[3] = {r * cos(turn), r * sin(turn), z};
    for (int i = 0; i < 3; i++)
        camera->position[i] = distance * way[i];
    assert_true(scene_camera_aim(camera) == SCENE_AIM_fine);
}

void bisection_body_fresh(BisectionBody *b)
{
    Displaced before = b->displaced; /* its programs are reused */
    if (b->mesh.array)
        mesh_delete(b->gl, &b->mesh);
    assert_true(mesh_make_captured(b->gl, &b->mesh));
    b->mesh.body = shape_body(&b->scene->meshes[b->scene->objects[0].mesh].shape) == SHAPE_BODY_none
                       ? SHAPE_BODY_none
                       : SHAPE_BODY_closed;
    if (!displaced_make(b->store, b->scene, &b->options, b->scene->objects[0].mesh, &b->displaced))
        fail_msg("%s", b->gl->error);
    displaced_delete(&before);
}

BisectionBody bisection_body_begin(const BisectionBodies *with, const char *how, const char *object)
{
    BisectionBody b = {.gl = with->gl, .store = with->store, .options = frame_exact_options()};
    b.scene = bisection_body_scene(how, object, &b.options, &b.document);
    bisection_body_fresh(&b);
    return b;
}

void bisection_body_end(BisectionBody *b)
{
    displaced_delete(&b->displaced);
    mesh_delete(b->gl, &b->mesh);
    frame_forget(b->scene, b->document);
}

int bisection_bodies_open(void **state)
{
    BisectionBodies *with = calloc(1, sizeof *with);
    with->gl = frame_context();
    with->store = store_new(with->gl);
    if (!with->store || !displaced_supported(with->gl, KEYWORD_Displacing_bisection))
        return -1;
    for (int i = 0; i < 2; i++)
        with->kept[i] =
            bisection_body_begin(with, "pixels: 1, triangles: 1000", bisection_bodies[2 + i]);
    *state = with;
    return 0;
}

int bisection_bodies_close(void **state)
{
    BisectionBodies *with = *state;
    for (int i = 0; i < 2; i++)
        bisection_body_end(&with->kept[i]);
    store_free(with->store);
    gl_close(with->gl);
    free(with);
    return 0;
}

static int by_value(const void *a, const void *b)
{
    const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

void bisection_body_sort(uint64_t *leaves, int count)
{
    qsort(leaves, (size_t)count, sizeof *leaves, by_value);
}

uint64_t *bisection_body_leaves(BisectionBody *b, int *count)
{
    DisplacedView view = {b->scene, {EDGE, EDGE}, {0}, {0}, {0}};
    memcpy(view.low, b->low, sizeof b->low);
    memcpy(view.high, b->high, sizeof b->high);
    if (!displaced_write(&b->displaced, &view, &b->mesh))
        fail_msg("%s", b->gl->error);
    uint64_t *leaves = displaced_bisection_leaves(&b->displaced, count);
    assert_non_null(leaves);
    bisection_body_sort(leaves, *count);
    return leaves;
}

/* Number of elements of either set that are missing in the other. */
int bisection_body_others(const uint64_t *a, int a_count, const uint64_t *b, int b_count)
{
    int i = 0, k = 0, count = 0;
    while (i < a_count || k < b_count) {
        const bool has_a = i < a_count, has_b = k < b_count;
        count += !(has_a && has_b && a[i] == b[k]);
        const bool take_a = has_a && (!has_b || a[i] <= b[k]),
                   take_b = has_b && (!has_a || b[k] <= a[i]);
        i += take_a;
        k += take_b;
    }
    return count;
}
