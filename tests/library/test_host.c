/* The renderer as a library (matc_render.h), on a context that the host made: pictures equal
 * those on the renderer's own context, also after changes and with displaced meshes; refused
 * calls; and the host's GL state stays unchanged. */
/* ctest: seconds=60 */
#include "tests/test.h"
#include "runtime/gl/backend.h"
#include "runtime/renderer/matc_render.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 48, HEIGHT = 32, FLOATS = WIDTH * HEIGHT * 4 };

static const char text[] =
    "image: { width: 48, height: 32 }\ncamera: { camera: Perspective, position: [0, -5, 1], "
    "target: [0, 0, 0] }\n"
    "lights: [{ light: Point, position: [2, -4, 3], intensity: 9 }]\nobjects:\n"
    "- { object: Sphere, material: { material: Phong, diffuse: { param: paint, default: [.6, .3, "
    ".1] } } }\n"
    "- { object: Box, transform: { translation: [1, 0, 0] }, material: { material: Phong, diffuse: "
    ".5 } }\n";

typedef struct {
    GlContext *owner;
    MatcDocument *document;
    MatcScene *scene;
    MatcRenderer *render;
} Host;

static MatcRendererProc load(void *user, const char *name)
{
    return gl_backend_osmesa.load(((const GlContext *)user)->state, name);
}

static Host open_host_of(const char *document_text)
{
    char error[512] = "";
    Host h = {.owner = frame_context()};
    h.scene =
        matc_scene_read("scene.yaml", document_text, strlen(document_text), NULL, &h.document);
    assert_non_null(h.scene);
    h.render = matc_renderer_open(
        &(MatcRendererOptions){sizeof(MatcRendererOptions), load, h.owner, NULL, NULL, 0, 0}, error,
        sizeof error);
    if (!h.render)
        fail_msg("%s", error);
    return h;
}

static Host open_host(void) { return open_host_of(text); }

/* Closes the host; the context stays usable. */
static void close_host(Host *h)
{
    matc_renderer_close(h->render);
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
    assert_true(rgba && matc_renderer_frame(h->render) && matc_renderer_read(h->render, rgba));
    return rgba;
}

/* Compares with a renderer on its own context, bit for bit, at first and after each change. */
static void assert_as_own(const Host *h, const char *document_text)
{
    MatcOptions options;
    MatcDocument *document;
    matc_options_init(&options);
    options.pixels = true;
    float *host = read_host(h);
    Scene *scene = frame_scene(document_text, &options, &document);
    GlContext *gl = frame_context();
    float *own = frame_floats(gl, scene, &(RendererOptions){.compile = &options});
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
    assert_true(matc_renderer_set_scene(h.render, h.scene));
    assert_int_equal(matc_renderer_width(h.render), WIDTH);
    assert_int_equal(matc_renderer_height(h.render), HEIGHT);
    assert_int_equal(matc_scene_object_count(h.scene), 2);
    assert_int_equal(matc_scene_light_count(h.scene), 1);
    assert_int_equal(matc_scene_material_count(h.scene), 2);
    assert_int_not_equal(matc_renderer_texture(h.render), 0);
    assert_as_own(&h, text);
    double matrix[16];
    matc_scene_matrix(h.scene, 1, matrix);
    matrix[12] = -1.5;
    assert_true(matc_renderer_set_object(h.render, 1, matrix));
    char *changed = with("[1, 0, 0]", "[-1.5, 0, 0]");
    assert_as_own(&h, changed);
    free(changed);
    matrix[12] = 1;
    assert_true(matc_renderer_set_object(h.render, 1, matrix));
    assert_true(matc_renderer_set_camera(h.render, (double[]){2, -4, 3}, (double[]){0, 0, 0},
                                         (double[]){0, 0, 1}));
    changed = with("[0, -5, 1]", "[2, -4, 3]");
    assert_as_own(&h, changed);
    free(changed);
    assert_true(matc_renderer_set_camera(h.render, (double[]){0, -5, 1}, (double[]){0, 0, 0},
                                         (double[]){0, 0, 1}));
    assert_true(matc_renderer_set_light(h.render, 0, (double[]){-2, -4, 3}, (double[]){4, 4, 4}));
    changed = with("[2, -4, 3], intensity: 9", "[-2, -4, 3], intensity: 4");
    assert_as_own(&h, changed);
    free(changed);
    close_host(&h);
}

/* Two of one mesh, whose height goes by a param; one whose height goes by where it is; and one that
 * is as it was. */
#define DISPLACED(height, paint, first, scale, third)                                              \
    "image: { width: 48, height: 32 }\ncamera: { camera: Perspective, position: [0, -5, 1], "      \
    "target: [0, 0, 0] }\n"                                                                        \
    "lights: [{ light: Directional, direction: [1, 1, -1], intensity: 0.9 }]\ndisplacement: { "    \
    "triangles: 2000 }\n"                                                                          \
    "materials:\n  wave: { material: Phong, diffuse: { param: paint, default: [" paint             \
    "] }, displacementScale: { param: height, default: " height " },\n"                            \
    "    displacement: { map: Gradient, direction: [7, 0, 5], waveForm: Sin } }\n"                 \
    "  rock: { material: Phong, diffuse: .7, displacementScale: 0.3, displacement: { map: "        \
    "VolumeTurbulence, input: { "                                                                  \
    "map: XYZTransform, useGlobal: true, transform: { scale: 2 } } } }\n"                          \
    "objects:\n- { object: Sphere, radius: .8, material: wave, transform: { translation: [" first  \
    "] } }\n"                                                                                      \
    "- { object: Sphere, radius: .8, material: wave, transform: { translation: [1, 0, 0], "        \
    "scale: " scale " } }\n"                                                                       \
    "- { object: Box, material: rock, transform: { translation: [" third "] } }\n"                 \
    "- { object: Cone, material: { material: Phong }, transform: { translation: [0, 1, 0] } }\n"

/* An object displaced by a param, by its position, or by its size, changes its shape with these. */
static void displaces_again(void **state)
{
    (void)state;
    double matrix[16];
    Host h = open_host_of(DISPLACED("0.1", "1, 1, 1", "-1, 0, 0", "1", "0, 0, 0"));
    assert_true(matc_renderer_set_scene(h.render, h.scene));
    assert_as_own(&h, DISPLACED("0.1", "1, 1, 1", "-1, 0, 0", "1", "0, 0, 0"));
    assert_true(matc_renderer_set_param(h.render, 0, "paint", (float[]){1, .5f, .25f}, 3));
    assert_true(matc_renderer_set_param(h.render, 0, "height", (float[]){.25f}, 1));
    assert_true(matc_renderer_set_param(h.render, 0, "height", (float[]){.25f}, 1));
    assert_as_own(&h, DISPLACED("0.25", "1, .5, .25", "-1, 0, 0", "1", "0, 0, 0"));
    matc_scene_matrix(h.scene, 2, matrix);
    matrix[12] = .5;
    assert_true(matc_renderer_set_object(h.render, 2, matrix));
    assert_as_own(&h, DISPLACED("0.25", "1, .5, .25", "-1, 0, 0", "1", "0.5, 0, 0"));
    matc_scene_matrix(h.scene, 0, matrix);
    matrix[12] = -.5;
    assert_true(matc_renderer_set_object(h.render, 0, matrix));
    matc_scene_matrix(h.scene, 1, matrix);
    matrix[0] = matrix[5] = matrix[10] = .5;
    assert_true(matc_renderer_set_object(h.render, 1, matrix));
    assert_as_own(&h, DISPLACED("0.25", "1, .5, .25", "-.5, 0, 0", "0.5", "0.5, 0, 0"));
    assert_false(matc_renderer_set_param(h.render, 0, "height", (float[]){1, 2}, 2));
    assert_true(matc_renderer_set_param(h.render, 0, "height", (float[]){0}, 1));
    assert_true(matc_renderer_set_param(h.render, 0, "height", (float[]){.1f}, 1));
    assert_as_own(&h,
                  DISPLACED("0.10000000149011612", "1, .5, .25", "-.5, 0, 0", "0.5", "0.5, 0, 0"));
    close_host(&h);
}

/* Changes from one method to the next, and back, and to an unknown one. */
static void casts_otherwise(void **state)
{
    (void)state;
    static const char *const methods[] = {"hybrid", "map",    "exact", "silhouette",
                                          "none",   "hybrid", "exact", "map"};
    Host h = open_host();
    assert_true(matc_renderer_set_scene(h.render, h.scene));
    /* it stays */
    assert_true(matc_renderer_set_param(h.render, 0, "paint", (float[3]){.2f, .5f, .1f}, 3));
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        char to[64];
        snprintf(to, sizeof to, "intensity: 9, shadows: %s", methods[i]);
        assert_true(matc_renderer_set_shadows(h.render, 0, methods[i]));
        char *changed = with("intensity: 9", to),
             *painted = changed_from(changed, "[.6, .3, .1]", "[.2, .5, .1]");
        assert_as_own(&h, painted);
        free(painted);
        free(changed);
    }
    assert_false(matc_renderer_set_shadows(h.render, 0, "soft"));
    assert_string_equal(matc_renderer_error(h.render), "the light 0 cannot have shadows 'soft'");
    assert_false(matc_renderer_set_shadows(h.render, 1, "map"));
    close_host(&h);
}

/* -- editing: each change draws what a text with that change draws, bit for bit */

#define EDITED(camera, image, objects)                                                             \
    "image: { " image " }\ncamera: { " camera ", position: [0, -5, 1], target: [0, 0, 0] }\n"      \
    "lights: [{ light: Point, name: lamp, position: [2, -4, 3], intensity: 9 }]\nmaterials:\n"     \
    "  paint: { material: Phong, diffuse: [.6, .3, .1] }\n  grey: { material: Phong, diffuse: .5 " \
    "}\n"                                                                                          \
    "  spare: { material: Phong, diffuse: [.1, .4, .2] }\nobjects:\n" objects
#define BALL "- { object: Sphere, name: ball, material: paint }\n"
#define BOXES                                                                                      \
    "- { object: Group, name: boxes, transform: { translation: [1, 0, 0] }, objects: [{ object: "  \
    "Box, name: one, "                                                                             \
    "material: grey }, { object: Box, material: grey, transform: { translation: [-2.4, 0, 0] } "   \
    "}] }\n"
#define USUAL "camera: Perspective"
#define SMALL "width: 48, height: 32"

static void hides_and_removes(void **state)
{
    (void)state;
    Host h = open_host_of(EDITED(USUAL, SMALL, BALL BOXES));
    assert_true(matc_renderer_set_scene(h.render, h.scene));
    const int ball = matc_scene_find_object(h.scene, "ball", -1);
    assert_int_equal(ball, 0);
    assert_true(matc_scene_set_visible(h.scene, ball, false));
    assert_true(matc_renderer_update(h.render));
    assert_as_own(&h, EDITED(USUAL, SMALL, BOXES));
    double matrix[16]; /* what is hidden may move */
    matc_scene_matrix(h.scene, ball, matrix);
    matrix[14] = .5;
    assert_true(matc_renderer_set_object(h.render, ball, matrix));
    matrix[14] = 0;
    assert_true(matc_renderer_set_object(h.render, ball, matrix));
    assert_true(matc_scene_set_visible(h.scene, ball, true));
    assert_true(matc_renderer_update(h.render));
    assert_as_own(&h, EDITED(USUAL, SMALL, BALL BOXES));
    for (int i = -1; (i = matc_scene_find_object(h.scene, "boxes", i)) >= 0;)
        assert_true(matc_scene_remove_object(h.scene, i));
    assert_true(matc_renderer_update(h.render));
    assert_as_own(&h, EDITED(USUAL, SMALL, BALL));
    assert_true(matc_scene_remove_object(h.scene, ball)); /* nothing is left */
    assert_true(matc_renderer_update(h.render) && matc_renderer_frame(h.render));
    close_host(&h);
}

/* Shadows of each method, and edges, omit hidden objects. */
static void hides_from_every_shadow(void **state)
{
    (void)state;
    static const char *const methods[] = {"map", "exact", "silhouette", "hybrid"};
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        char whole[1024], left[1024], to[64];
        snprintf(to, sizeof to, "intensity: 9, shadows: %s", methods[i]);
        char *with_all = changed_from(
                 EDITED(USUAL, SMALL, BALL BOXES "- { object: Plane, material: grey }\n"),
                 "intensity: 9", to),
             *without =
                 changed_from(EDITED(USUAL, SMALL, BOXES "- { object: Plane, material: grey }\n"),
                              "intensity: 9", to);
        snprintf(whole, sizeof whole, "%s", with_all);
        snprintf(left, sizeof left, "%s", without);
        free(with_all);
        free(without);
        Host h = open_host_of(whole);
        assert_true(matc_scene_set_visible(h.scene, 0, false));
        assert_true(matc_renderer_set_scene(h.render, h.scene));
        assert_as_own(&h, left);
        close_host(&h);
    }
}

/* A hidden object fills no voxel: it occludes no light, and sends none. */
static void hides_from_voxels(void **state)
{
    (void)state;
#define LIT "indirect: { method: voxels, rays: 4 }\n"
    Host h = open_host_of(LIT EDITED(USUAL, SMALL, BALL BOXES));
    assert_true(matc_renderer_set_scene(h.render, h.scene));
    assert_as_own(&h, LIT EDITED(USUAL, SMALL, BALL BOXES));
    assert_true(matc_scene_set_visible(h.scene, 0, false));
    assert_true(matc_renderer_update(h.render));
    assert_as_own(&h, LIT EDITED(USUAL, SMALL, BOXES));
    close_host(&h);
}

/* A square mesh in memory equals the document's Parallelogram. */
static void adds_meshes(void **state)
{
    (void)state;
    static const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0},
                       normals[] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1},
                       coordinates[] = {0, 0, 1, 0, 0, 1, 1, 1};
    static const unsigned indices[] = {0, 1, 3, 0, 3, 2};
    static const double matrix[16] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, -1, -1, -.5, 1};
    const MatcMesh square = {sizeof square, positions, normals, coordinates, indices, 4, 6};
    Host h = open_host_of(EDITED(USUAL, SMALL, BALL BOXES));
    assert_true(matc_renderer_set_scene(h.render, h.scene));
    const int spare = matc_scene_find_material(h.scene, "spare"),
              mesh = matc_scene_add_mesh(h.scene, &square);
    assert_true(spare >= 0 && mesh >= 0);
    assert_int_equal(matc_scene_find_material(h.scene, "spare"), spare);
    assert_int_equal(matc_scene_add_object(h.scene, mesh, spare, matrix), 3);
    assert_true(matc_renderer_update(h.render));
    const char *added =
        EDITED(USUAL, SMALL,
               BALL BOXES "- { object: Parallelogram, material: spare, transform: { "
                          "scale: 2, translation: [-1, -1, -.5] } }\n");
    assert_as_own(&h, added);
    assert_true(matc_scene_remove_object(h.scene, 3));
    assert_true(matc_renderer_update(h.render));
    assert_as_own(&h, EDITED(USUAL, SMALL, BALL BOXES));
    /* the free place again */
    assert_int_equal(matc_scene_add_object(h.scene, mesh, spare, matrix), 3);
    for (int i = 0; i < 40; i++) /* arrays grow */
        assert_int_equal(
            matc_scene_add_object(h.scene, matc_scene_add_mesh(h.scene, &square), 0, matrix),
            4 + i);
    for (int i = 0; i < 40; i++)
        assert_true(matc_scene_remove_object(h.scene, 4 + i));
    assert_true(matc_renderer_update(h.render));
    assert_as_own(&h, added);
    close_host(&h);
}

static void projects_and_resizes(void **state)
{
    (void)state;
    Host h = open_host_of(EDITED(USUAL, SMALL, BALL BOXES));
    assert_true(matc_renderer_set_scene(h.render, h.scene));
    assert_true(matc_renderer_set_perspective(h.render, 25, 4.5));
    assert_as_own(&h, EDITED("camera: Perspective, angle: 25, near: 4.5", SMALL, BALL BOXES));
    assert_true(matc_renderer_set_orthographic(h.render, 3, 5));
    assert_as_own(&h, EDITED("camera: Orthographic, size: 3, depth: 5", SMALL, BALL BOXES));
    assert_true(matc_renderer_set_perspective(h.render, 40, .01));
    assert_true(matc_renderer_set_size(h.render, 32, 48)); /* as many pixels, for read_host */
    assert_int_equal(matc_renderer_width(h.render), 32);
    assert_as_own(&h, EDITED(USUAL, "width: 32, height: 48", BALL BOXES));
    assert_true(matc_renderer_set_size(h.render, 0, 0));
    assert_as_own(&h, EDITED(USUAL, SMALL, BALL BOXES));
    close_host(&h);
}

static void goes_by_time(void **state)
{
    (void)state;
    static const char moving[] =
        "image: { width: 48, height: 32 }\nlights: [{ light: Ambient }]\nobjects:\n"
        "- { object: Sphere, material: { material: Phong, ambient: \"= .5 + .5 * sin(time)\" } }\n";
    Host h = open_host_of(moving);
    assert_true(matc_renderer_set_scene(h.render, h.scene));
    float *first = read_host(&h), *later, *back;
    assert_true(matc_renderer_set_time(h.render, 1.5707963267948966));
    later = read_host(&h);
    const size_t middle = ((HEIGHT / 2) * WIDTH + WIDTH / 2) * 4;
    assert_true(fabsf(later[middle] - 1) < 1e-3f); /* .5 + .5 sin(pi / 2), in sRGB too */
    assert_true(first[middle] < .8f);
    assert_true(matc_renderer_set_time(h.render, 0));
    back = read_host(&h);
    assert_memory_equal(first, back, FLOATS * sizeof *first);
    free(first);
    free(later);
    free(back);
    close_host(&h);
}

/* The picture is written to the given rectangle of the host's framebuffer and to no other pixel. */
static void draws_to_a_framebuffer(void **state)
{
    (void)state;
    enum { SIDE = 80 };
    static unsigned char got[SIDE * SIDE * 4];
    Host h = open_host_of(EDITED(USUAL, SMALL, BALL BOXES));
    GlContext *gl = h.owner;
    GLuint texture = 0, framebuffer = 0;
    assert_true(matc_renderer_set_scene(h.render, h.scene));
    float *picture = read_host(&h);
    gl->GenTextures(1, &texture);
    gl->BindTexture(GL_TEXTURE_2D, texture);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, SIDE, SIDE, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    gl->GenFramebuffers(1, &framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    gl->ClearColor(0, 0, 1, 1);
    gl->Clear(GL_COLOR_BUFFER_BIT);
    gl->ClearColor(0, 0, 0, 0);
    assert_true(matc_renderer_draw(h.render, framebuffer, (int[]){10, 20, WIDTH, HEIGHT}));
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    gl->ReadPixels(0, 0, SIDE, SIDE, GL_RGBA, GL_UNSIGNED_BYTE, got);
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) {
            const unsigned char *at = got + 4 * (y * SIDE + x);
            const bool within = x >= 10 && x < 10 + WIDTH && y >= 20 && y < 20 + HEIGHT;
            const float *of = picture + 4 * ((y - 20) * WIDTH + x - 10);
            for (int k = 0; k < 3; k++)
                assert_int_equal(at[k], within ? (int)lrintf(of[k] * 255) : k == 2 ? 255 : 0);
        }
    assert_false(matc_renderer_draw(h.render, framebuffer, (int[]){0, 0, 0, 5}));
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    free(picture);
    close_host(&h);
}

static void finds_by_name(void **state)
{
    (void)state;
    Host h = open_host_of(EDITED(USUAL, SMALL,
                                 BALL BOXES
                                 "- { object: Scatter, name: crowd, count: 3, objects: [{ object: "
                                 "Sphere, name: head, radius: .1, material: grey }] }\n"));
    assert_string_equal(matc_scene_object_name(h.scene, 1), "boxes/one");
    assert_string_equal(matc_scene_object_name(h.scene, 2), "boxes");
    assert_string_equal(matc_scene_object_name(h.scene, 5), "crowd/head");
    assert_int_equal(matc_scene_find_object(h.scene, "boxes", -1), 1);
    assert_int_equal(matc_scene_find_object(h.scene, "boxes", 1), 2);
    assert_int_equal(matc_scene_find_object(h.scene, "boxes", 2), -1);
    assert_int_equal(matc_scene_find_object(h.scene, "boxes/one", -1), 1);
    assert_int_equal(matc_scene_find_object(h.scene, "crowd", 3), 4);
    assert_int_equal(matc_scene_find_object(h.scene, "box", -1), -1);
    assert_int_equal(matc_scene_find_light(h.scene, "lamp"), 0);
    assert_int_equal(matc_scene_find_light(h.scene, "lam"), -1);
    assert_int_equal(matc_scene_find_material(h.scene, "grey"), 1);
    assert_int_equal(matc_scene_find_material(h.scene, "none"), -1);
    close_host(&h);
}

/* Every wrong argument is refused with a reason, and the picture stays unchanged. */
static void edits_refused(void **state)
{
    (void)state;
    static const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0},
                       broken[] = {0, 0, 0, 1, 0, NAN, 0, 1, 0};
    static const unsigned far_index[] = {0, 1, 3}, two[] = {0, 1};
    static const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
                        flat[16] = {1, [15] = 1}, none[16] = {NAN};
    static const MatcMesh wrong[] = {
        {0, positions, NULL, NULL, NULL, 3, 0},
        {sizeof(MatcMesh), NULL, NULL, NULL, NULL, 3, 0},
        {sizeof(MatcMesh), positions, NULL, NULL, NULL, 0, 0},
        {sizeof(MatcMesh), positions, NULL, NULL, NULL, -3, 0},
        {sizeof(MatcMesh), positions, NULL, NULL, NULL, 2, 0},
        {sizeof(MatcMesh), positions, NULL, NULL, NULL, INT32_MAX, 0},
        {sizeof(MatcMesh), broken, NULL, NULL, NULL, 3, 0},
        {sizeof(MatcMesh), positions, NULL, NULL, far_index, 3, 3},
        {sizeof(MatcMesh), positions, NULL, NULL, two, 3, 2},
        {sizeof(MatcMesh), positions, NULL, NULL, two, 3, -1},
        {sizeof(MatcMesh), positions, NULL, NULL, two, 3, 0},
        {sizeof(MatcMesh), positions, NULL, NULL, NULL, 3, 3},
    };
    const MatcMesh right = {sizeof right, positions, NULL, NULL, NULL, 3, 0};
    Host h = open_host_of(EDITED(USUAL, SMALL, BALL BOXES));
    const int rectangle[4] = {0, 0, 4, 4};
    assert_false(matc_renderer_update(h.render));
    assert_false(matc_renderer_set_time(h.render, 1));
    assert_false(matc_renderer_set_perspective(h.render, 40, 1));
    assert_false(matc_renderer_draw(h.render, 0, rectangle));
    assert_true(matc_renderer_set_scene(h.render, h.scene));
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        ((char *)matc_scene_error(h.scene))[0] = 0;
        assert_int_equal(matc_scene_add_mesh(h.scene, &wrong[i]), -1);
        assert_int_not_equal(strlen(matc_scene_error(h.scene)), 0);
    }
    assert_int_equal(matc_scene_add_mesh(h.scene, NULL), -1);
    const int mesh = matc_scene_add_mesh(h.scene, &right);
    assert_int_equal(matc_scene_add_object(h.scene, mesh + 1, 0, identity), -1);
    assert_int_equal(matc_scene_add_object(h.scene, -1, 0, identity), -1);
    assert_int_equal(matc_scene_add_object(h.scene, mesh, 9, identity), -1);
    assert_int_equal(matc_scene_add_object(h.scene, mesh, -1, identity), -1);
    assert_int_equal(matc_scene_add_object(h.scene, mesh, 0, flat), -1);
    assert_int_equal(matc_scene_add_object(h.scene, mesh, 0, none), -1);
    static const int objects[] = {-1, 3, INT32_MAX, INT32_MIN};
    for (size_t i = 0; i < sizeof objects / sizeof *objects; i++) {
        double matrix[16];
        assert_false(matc_scene_set_visible(h.scene, objects[i], false));
        assert_false(matc_scene_remove_object(h.scene, objects[i]));
        assert_null(matc_scene_object_name(h.scene, objects[i]));
        matc_scene_matrix(h.scene, objects[i], matrix);
        assert_memory_equal(matrix, identity, sizeof matrix);
    }
    assert_int_equal(matc_scene_find_object(h.scene, "ball", INT32_MAX), -1);
    assert_false(matc_renderer_set_perspective(h.render, 180, 1) ||
                 matc_renderer_set_perspective(h.render, 0, 1) ||
                 matc_renderer_set_perspective(h.render, NAN, 1) ||
                 matc_renderer_set_perspective(h.render, 40, 0) ||
                 matc_renderer_set_orthographic(h.render, -1, 1) ||
                 matc_renderer_set_orthographic(h.render, 1, NAN) ||
                 matc_renderer_set_time(h.render, INFINITY) ||
                 matc_renderer_set_size(h.render, -1, 5) ||
                 matc_renderer_set_size(h.render, 5, 1 << 20));
    assert_int_not_equal(strlen(matc_renderer_error(h.render)), 0);
    assert_true(matc_renderer_update(h.render));
    assert_as_own(&h, EDITED(USUAL, SMALL, BALL BOXES));
    close_host(&h);
}

static void refused(void **state)
{
    (void)state;
    char error[128] = "";
    MatcDocument *document;
    Host h = open_host();
    const double nothing[16] = {NAN}, origin[3] = {0};
    assert_null(matc_renderer_open(&(MatcRendererOptions){.load = load}, error, sizeof error));
    assert_string_equal(error,
                        "MatcRendererOptions.size is 0; it must be sizeof(MatcRendererOptions)");
    assert_null(
        matc_renderer_open(&(MatcRendererOptions){.size = sizeof(size_t)}, error, sizeof error));
    assert_string_equal(error, "no function that loads is given");
    assert_null(matc_renderer_open(
        &(MatcRendererOptions){sizeof(MatcRendererOptions), load, h.owner, NULL, "deep", 0, 0},
        error, sizeof error));
    assert_non_null(strstr(error, "unknown view 'deep'"));
    assert_false(matc_renderer_frame(h.render));
    assert_false(matc_renderer_set_object(h.render, 0, nothing));
    assert_string_equal(matc_renderer_error(h.render), "no scene to change");
    assert_true(matc_renderer_set_scene(h.render, h.scene));
    assert_false(matc_renderer_set_object(h.render, 2, nothing));
    assert_string_equal(matc_renderer_error(h.render), "no object 2");
    assert_false(matc_renderer_set_object(h.render, 1, nothing));
    assert_string_equal(matc_renderer_error(h.render), "the matrix has what is no number");
    assert_false(matc_renderer_set_camera(h.render, origin, origin, origin));
    assert_false(
        matc_renderer_set_camera(h.render, (double[]){0, 0, 1}, origin, (double[]){0, 0, 2}));
    assert_string_equal(matc_renderer_error(h.render), "up, seen along the view, has no direction");
    assert_false(matc_renderer_set_light(h.render, -1, origin, origin));
    assert_false(matc_renderer_set_param(h.render, 0, "paints", (float[3]){0}, 3));
    assert_as_own(&h, text); /* none of it changed anything */
    assert_null(matc_scene_read("m.yaml", "material: Phong\n", 16, NULL, &document));
    assert_non_null(strstr(matc_diagnostics(document, MATC_TEXT), "the document is not a scene"));
    matc_document_free(document);
    close_host(&h);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(draws_and_changes),      cmocka_unit_test(displaces_again),
        cmocka_unit_test(casts_otherwise),        cmocka_unit_test(refused),
        cmocka_unit_test(hides_and_removes),      cmocka_unit_test(hides_from_every_shadow),
        cmocka_unit_test(hides_from_voxels),      cmocka_unit_test(adds_meshes),
        cmocka_unit_test(projects_and_resizes),   cmocka_unit_test(goes_by_time),
        cmocka_unit_test(draws_to_a_framebuffer), cmocka_unit_test(finds_by_name),
        cmocka_unit_test(edits_refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
