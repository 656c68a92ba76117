/* The renderer as a library (matc_render.h), on a context that somebody else made: the same pictures as on one of its own, changes, of displaced meshes too, what is
 * refused, and that the context stays its owner's. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "runtime/gl/backend.h"
#include "runtime/render/matc_render.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 48, HEIGHT = 32, FLOATS = WIDTH * HEIGHT * 4 };

static const char text[] =
    "image: { width: 48, height: 32 }\ncamera: { camera: Perspective, position: [0, -5, 1], target: [0, 0, 0] }\n"
    "lights: [{ light: Point, position: [2, -4, 3], intensity: 9 }]\nobjects:\n"
    "- { object: Sphere, material: { material: Phong, diffuse: { param: paint, default: [.6, .3, .1] } } }\n"
    "- { object: Box, transform: { translation: [1, 0, 0] }, material: { material: Phong, diffuse: .5 } }\n";

typedef struct {
    GlContext *owner;
    MatcDocument *document;
    MatcScene *scene;
    MatcRender *render;
} Host;

static MatcRenderProc load(void *user, const char *name)
{
    return gl_backend_osmesa.load(((const GlContext *)user)->state, name);
}

static Host open_host_of(const char *document_text)
{
    char error[512] = "";
    Host h = {.owner = frame_context()};
    h.scene = matc_scene_read("scene.yaml", document_text, strlen(document_text), NULL, &h.document);
    assert_non_null(h.scene);
    h.render = matc_render_open(&(MatcRenderOptions){sizeof(MatcRenderOptions), load, h.owner, NULL, NULL, 0, 0}, error,
                                sizeof error);
    if (!h.render)
        fail_msg("%s", error);
    return h;
}

static Host open_host(void) { return open_host_of(text); }

/* The context goes on. */
static void close_host(Host *h)
{
    matc_render_close(h->render);
    matc_scene_free(h->scene);
    matc_document_free(h->document);
    GLuint texture = 0;
    h->owner->GenTextures(1, &texture);
    assert_true(texture && gl_check(h->owner, "what the library left"));
    gl_close(h->owner);
}

static float *read_host(const Host *h)
{
    float *rgba = calloc(FLOATS, sizeof *rgba);
    assert_true(rgba && matc_render_frame(h->render) && matc_render_read(h->render, rgba));
    return rgba;
}

/* As on a context of its own, bit for bit, at first and after each change. */
static void assert_as_own(const Host *h, const char *document_text)
{
    MatcOptions options;
    MatcDocument *document;
    matc_options_init(&options);
    options.pixels = true;
    float *host = read_host(h);
    Scene *scene = frame_scene(document_text, &options, &document);
    GlContext *gl = frame_context();
    float *own = frame_floats(gl, scene, &(RenderOptions){.compile = &options});
    assert_memory_equal(host, own, FLOATS * sizeof *own);
    gl_close(gl);
    assert_true(gl_use(h->owner));
    frame_forget(scene, document);
    free(host);
    free(own);
}

/* A text with one part of it replaced; from malloc. */
static char *changed_from(const char *whole, const char *from, const char *to)
{
    const char *at = strstr(whole, from);
    const size_t before = (size_t)(at - whole);
    char *changed = calloc(strlen(whole) + strlen(to) + 1, 1);
    memcpy(changed, whole, before);
    strcpy(changed + before, to);
    strcat(changed, at + strlen(from));
    return changed;
}

static char *with(const char *from, const char *to) { return changed_from(text, from, to); }

static void draws_and_changes(void **state)
{
    (void)state;
    Host h = open_host();
    assert_true(matc_render_scene(h.render, h.scene));
    assert_int_equal(matc_render_width(h.render), WIDTH);
    assert_int_equal(matc_render_height(h.render), HEIGHT);
    assert_int_equal(matc_scene_object_count(h.scene), 2);
    assert_int_equal(matc_scene_light_count(h.scene), 1);
    assert_int_equal(matc_scene_material_count(h.scene), 2);
    assert_int_not_equal(matc_render_texture(h.render), 0);
    assert_as_own(&h, text);
    double matrix[16];
    matc_scene_matrix(h.scene, 1, matrix);
    matrix[12] = -1.5;
    assert_true(matc_render_move(h.render, 1, matrix));
    char *changed = with("[1, 0, 0]", "[-1.5, 0, 0]");
    assert_as_own(&h, changed);
    free(changed);
    matrix[12] = 1;
    assert_true(matc_render_move(h.render, 1, matrix));
    assert_true(matc_render_look(h.render, (double[]){2, -4, 3}, (double[]){0, 0, 0}, (double[]){0, 0, 1}));
    changed = with("[0, -5, 1]", "[2, -4, 3]");
    assert_as_own(&h, changed);
    free(changed);
    assert_true(matc_render_look(h.render, (double[]){0, -5, 1}, (double[]){0, 0, 0}, (double[]){0, 0, 1}));
    assert_true(matc_render_light(h.render, 0, (double[]){-2, -4, 3}, (double[]){4, 4, 4}));
    changed = with("[2, -4, 3], intensity: 9", "[-2, -4, 3], intensity: 4");
    assert_as_own(&h, changed);
    free(changed);
    close_host(&h);
}

/* Two of one mesh, whose height goes by a param; one whose height goes by where it is; and one that is as it was. */
#define DISPLACED(height, paint, first, scale, third)                                                                  \
    "image: { width: 48, height: 32 }\ncamera: { camera: Perspective, position: [0, -5, 1], target: [0, 0, 0] }\n"     \
    "lights: [{ light: Directional, direction: [1, 1, -1], intensity: 0.9 }]\ndisplacement: { triangles: 2000 }\n"     \
    "materials:\n  wave: { material: Phong, diffuse: { param: paint, default: [" paint                                 \
    "] }, displacementScale: { param: height, default: " height " },\n"                                                \
    "    displacement: { map: Gradient, direction: [7, 0, 5], waveForm: Sin } }\n"                                     \
    "  rock: { material: Phong, diffuse: .7, displacementScale: 0.3, displacement: { map: VolumeTurbulence, input: { " \
    "map: XYZTransform, useGlobal: true, transform: { scale: 2 } } } }\n"                                              \
    "objects:\n- { object: Sphere, radius: .8, material: wave, transform: { translation: [" first "] } }\n"            \
    "- { object: Sphere, radius: .8, material: wave, transform: { translation: [1, 0, 0], scale: " scale " } }\n"      \
    "- { object: Box, material: rock, transform: { translation: [" third "] } }\n"                                     \
    "- { object: Cone, material: { material: Phong }, transform: { translation: [0, 1, 0] } }\n"

/* What is displaced by a param, by where it is, or how large, has another shape when that changes. */
static void displaces_again(void **state)
{
    (void)state;
    double matrix[16];
    Host h = open_host_of(DISPLACED("0.1", "1, 1, 1", "-1, 0, 0", "1", "0, 0, 0"));
    assert_true(matc_render_scene(h.render, h.scene));
    assert_as_own(&h, DISPLACED("0.1", "1, 1, 1", "-1, 0, 0", "1", "0, 0, 0"));
    assert_true(matc_render_param(h.render, 0, "paint", (float[]){1, .5f, .25f}, 3));
    assert_true(matc_render_param(h.render, 0, "height", (float[]){.25f}, 1));
    assert_true(matc_render_param(h.render, 0, "height", (float[]){.25f}, 1));
    assert_as_own(&h, DISPLACED("0.25", "1, .5, .25", "-1, 0, 0", "1", "0, 0, 0"));
    matc_scene_matrix(h.scene, 2, matrix);
    matrix[12] = .5;
    assert_true(matc_render_move(h.render, 2, matrix));
    assert_as_own(&h, DISPLACED("0.25", "1, .5, .25", "-1, 0, 0", "1", "0.5, 0, 0"));
    matc_scene_matrix(h.scene, 0, matrix);
    matrix[12] = -.5;
    assert_true(matc_render_move(h.render, 0, matrix));
    matc_scene_matrix(h.scene, 1, matrix);
    matrix[0] = matrix[5] = matrix[10] = .5;
    assert_true(matc_render_move(h.render, 1, matrix));
    assert_as_own(&h, DISPLACED("0.25", "1, .5, .25", "-.5, 0, 0", "0.5", "0.5, 0, 0"));
    assert_false(matc_render_param(h.render, 0, "height", (float[]){1, 2}, 2));
    assert_true(matc_render_param(h.render, 0, "height", (float[]){0}, 1));
    assert_true(matc_render_param(h.render, 0, "height", (float[]){.1f}, 1));
    assert_as_own(&h, DISPLACED("0.10000000149011612", "1, .5, .25", "-.5, 0, 0", "0.5", "0.5, 0, 0"));
    close_host(&h);
}

/* From one method to the next, and back, and by one that there is not. */
static void casts_otherwise(void **state)
{
    (void)state;
    static const char *const methods[] = {"hybrid", "map", "exact", "silhouette", "none", "hybrid", "exact", "map"};
    Host h = open_host();
    assert_true(matc_render_scene(h.render, h.scene));
    assert_true(matc_render_param(h.render, 0, "paint", (float[3]){.2f, .5f, .1f}, 3)); /* it stays */
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        char to[64];
        snprintf(to, sizeof to, "intensity: 9, shadows: %s", methods[i]);
        assert_true(matc_render_shadows(h.render, 0, methods[i]));
        char *changed = with("intensity: 9", to), *painted = changed_from(changed, "[.6, .3, .1]", "[.2, .5, .1]");
        assert_as_own(&h, painted);
        free(painted);
        free(changed);
    }
    assert_false(matc_render_shadows(h.render, 0, "soft"));
    assert_string_equal(matc_render_error(h.render), "the light 0 cannot have shadows 'soft'");
    assert_false(matc_render_shadows(h.render, 1, "map"));
    close_host(&h);
}

static void refused(void **state)
{
    (void)state;
    char error[128] = "";
    MatcDocument *document;
    Host h = open_host();
    const double nothing[16] = {NAN}, origin[3] = {0};
    assert_null(matc_render_open(&(MatcRenderOptions){.size = sizeof(size_t)}, error, sizeof error));
    assert_string_equal(error, "no function that loads is given");
    assert_null(matc_render_open(&(MatcRenderOptions){sizeof(MatcRenderOptions), load, h.owner, NULL, "deep", 0, 0},
                                 error, sizeof error));
    assert_non_null(strstr(error, "there is no view 'deep'"));
    assert_false(matc_render_frame(h.render));
    assert_false(matc_render_move(h.render, 0, nothing));
    assert_string_equal(matc_render_error(h.render), "there is no scene to change");
    assert_true(matc_render_scene(h.render, h.scene));
    assert_false(matc_render_move(h.render, 2, nothing));
    assert_string_equal(matc_render_error(h.render), "there is no object 2");
    assert_false(matc_render_move(h.render, 1, nothing));
    assert_string_equal(matc_render_error(h.render), "the matrix has what is no number");
    assert_false(matc_render_look(h.render, origin, origin, origin));
    assert_false(matc_render_look(h.render, (double[]){0, 0, 1}, origin, (double[]){0, 0, 2}));
    assert_string_equal(matc_render_error(h.render), "up, seen along the view, has no direction");
    assert_false(matc_render_light(h.render, -1, origin, origin));
    assert_false(matc_render_param(h.render, 0, "paints", (float[3]){0}, 3));
    assert_as_own(&h, text); /* none of it changed anything */
    assert_null(matc_scene_read("m.yaml", "material: Phong\n", 16, NULL, &document));
    matc_document_free(document);
    close_host(&h);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(draws_and_changes), cmocka_unit_test(displaces_again),
                                       cmocka_unit_test(casts_otherwise), cmocka_unit_test(refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
