/* Calls every function of matc_render.h with every kind of wrong argument. The call has to fail,
 * with a message in the scene's or renderer's error, and must not change the picture. A function of
 * the header without a row fails the test (api_rows.h). */
#include "tests/test.h"
#include "runtime/gl/backend.h"
#include "runtime/renderer/matc_render.h"
#include "tests/api_rows.h"
#include "tests/frame/frame_draw.h"
#include <limits.h>
#include <math.h>

enum { WIDTH = 32, HEIGHT = 24, FLOATS = WIDTH * HEIGHT * 4, MESSAGE = 512 };

static const char text[] =
    "image: { width: 32, height: 24 }\n"
    "camera: { camera: Perspective, position: [0, -5, 1], target: [0, 0, 0] }\n"
    "lights: [{ light: Point, name: lamp, position: [2, -4, 3], intensity: 9 }]\nobjects:\n"
    "- { object: Sphere, name: ball, material: { material: Phong, diffuse: { param: paint, "
    "default: [.6, .3, .1] } } }\n";
static const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
                    origin[3] = {0};
static const int outside[] = {-1, 1, 1000, INT_MAX, INT_MIN};
enum { OUTSIDE = sizeof outside / sizeof *outside };

/* Arguments that the rows share: a renderer with a scene, and one without. */
static struct {
    GlContext *owner;
    MatcDocument *document;
    MatcScene *scene;
    MatcRenderer *render, *empty;
    float before[FLOATS];
} of;

static MatcRendererProc load(void *user, const char *name)
{
    return gl_backend_osmesa.load(((const GlContext *)user)->state, name);
}

static MatcRendererProc load_nothing(void *user, const char *name)
{
    (void)user;
    (void)name;
    return NULL;
}

static MatcRenderer *open_renderer(void)
{
    const MatcRendererOptions options = {.size = sizeof options, .load = load, .user = of.owner};
    char error[MESSAGE] = "";
    MatcRenderer *render = matc_renderer_open(&options, error, sizeof error);
    if (!render)
        fail_msg("%s", error);
    return render;
}

static int open_all(void **state)
{
    (void)state;
    of.owner = frame_context();
    of.scene = matc_scene_read("scene.yaml", text, strlen(text), NULL, &of.document);
    of.render = open_renderer();
    of.empty = open_renderer();
    assert_true(matc_renderer_set_scene(of.render, of.scene) && matc_renderer_frame(of.render));
    assert_true(matc_renderer_read(of.render, of.before));
    return 0;
}

static int close_all(void **state)
{
    (void)state;
    matc_renderer_close(of.render);
    matc_renderer_close(of.empty);
    matc_scene_free(of.scene);
    matc_document_free(of.document);
    gl_close(of.owner);
    return 0;
}

/* -- each refused call has to set an error of its own */

static void forget_errors(void)
{
    *(char *)matc_renderer_error(of.render) = 0;
    *(char *)matc_renderer_error(of.empty) = 0;
    *(char *)matc_scene_error(of.scene) = 0;
}

#define REFUSED(call, error)                                                                       \
    do {                                                                                           \
        forget_errors();                                                                           \
        assert_false(call);                                                                        \
        if (!*(error))                                                                             \
            fail_msg("%s fails without a reason", #call);                                          \
    } while (0)
#define SCENE_REFUSES(call)  REFUSED(call, matc_scene_error(of.scene))
#define RENDER_REFUSES(call) REFUSED(call, matc_renderer_error(of.render))
#define EMPTY_REFUSES(call)  REFUSED(call, matc_renderer_error(of.empty))

/* -- scenes */

static void wrong_scene_read(void)
{
    MatcDocument *document = NULL;
    const MatcOptions unset = {.validate = true};
    const struct {
        const char *name, *text;
        size_t size;
        const MatcOptions *options;
    } wrong[] = {{"a.yaml", NULL, 0, NULL},
                 {"a.yaml", NULL, SIZE_MAX, NULL},
                 {NULL, NULL, 5, NULL},
                 {"a.yaml", "", 0, NULL},
                 {"a.yaml", "[", 1, NULL},
                 {"a.yaml", "material: Phong\n", 16, NULL},
                 {"a.yaml", text, strlen(text), &unset}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        assert_null(matc_scene_read(wrong[i].name, wrong[i].text, wrong[i].size, wrong[i].options,
                                    &document));
        assert_non_null(document);
        assert_true(matc_error_count(document) > 0 && *matc_diagnostics(document, MATC_TEXT));
        matc_document_free(document);
    }
    assert_null(matc_scene_read("a.yaml", text, strlen(text), NULL, NULL));
    MatcScene *nameless = matc_scene_read(NULL, text, strlen(text), NULL, &document);
    assert_non_null(nameless);
    matc_scene_free(nameless);
    matc_document_free(document);
}

static void wrong_scene_free(void) { matc_scene_free(NULL); }
static void wrong_scene_object_count(void) { assert_int_equal(matc_scene_object_count(NULL), 0); }
static void wrong_scene_light_count(void) { assert_int_equal(matc_scene_light_count(NULL), 0); }
static void wrong_scene_material_count(void)
{
    assert_int_equal(matc_scene_material_count(NULL), 0);
}
static void wrong_scene_error(void)
{
    assert_string_equal(matc_scene_error(NULL), "the scene is NULL");
}

static void wrong_scene_matrix(void)
{
    double matrix[16];
    matc_scene_matrix(of.scene, 0, NULL);
    matc_scene_matrix(NULL, 0, matrix);
    assert_memory_equal(matrix, identity, sizeof matrix);
    for (int i = 0; i < OUTSIDE; i++) {
        matrix[0] = 7;
        matc_scene_matrix(of.scene, outside[i], matrix);
        assert_memory_equal(matrix, identity, sizeof matrix);
    }
}

static void wrong_scene_object_name(void)
{
    assert_null(matc_scene_object_name(NULL, 0));
    for (int i = 0; i < OUTSIDE; i++)
        assert_null(matc_scene_object_name(of.scene, outside[i]));
}

static void wrong_scene_find_object(void)
{
    assert_int_equal(matc_scene_find_object(NULL, "ball", -1), -1);
    assert_int_equal(matc_scene_find_object(of.scene, NULL, -1), -1);
    assert_int_equal(matc_scene_find_object(of.scene, "bal", -1), -1);
    assert_int_equal(matc_scene_find_object(of.scene, "ball", INT_MAX), -1);
    /* searches from the start */
    assert_int_equal(matc_scene_find_object(of.scene, "ball", INT_MIN), 0);
}

static void wrong_scene_find_light(void)
{
    assert_int_equal(matc_scene_find_light(NULL, "lamp"), -1);
    assert_int_equal(matc_scene_find_light(of.scene, NULL), -1);
    assert_int_equal(matc_scene_find_light(of.scene, ""), -1);
}

static void wrong_scene_find_material(void)
{
    assert_int_equal(matc_scene_find_material(NULL, "a"), -1);
    SCENE_REFUSES(matc_scene_find_material(of.scene, NULL) >= 0);
    SCENE_REFUSES(matc_scene_find_material(of.scene, "none") >= 0);
}

static void wrong_scene_add_mesh(void)
{
    static const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0},
                       broken[] = {0, 0, 0, 1, 0, NAN, 0, 1, 0};
    static const unsigned beyond[] = {0, 1, 3};
    const MatcMesh wrong[] = {
        {0, positions, NULL, NULL, NULL, 3, 0},
        {sizeof(MatcMesh), NULL, NULL, NULL, NULL, 3, 0},
        {sizeof(MatcMesh), positions, NULL, NULL, NULL, INT_MIN, 0},
        {sizeof(MatcMesh), positions, NULL, NULL, NULL, 2, 0},
        {sizeof(MatcMesh), positions, NULL, NULL, NULL, INT_MAX, 0},
        {sizeof(MatcMesh), broken, NULL, NULL, NULL, 3, 0},
        {sizeof(MatcMesh), positions, broken, NULL, NULL, 3, 0},
        {sizeof(MatcMesh), positions, NULL, broken, NULL, 3, 0},
        {sizeof(MatcMesh), positions, NULL, NULL, beyond, 3, 3},
        {sizeof(MatcMesh), positions, NULL, NULL, beyond, 3, INT_MIN},
        {sizeof(MatcMesh), positions, NULL, NULL, NULL, 3, 3},
    };
    assert_int_equal(matc_scene_add_mesh(NULL, &wrong[0]), -1);
    SCENE_REFUSES(matc_scene_add_mesh(of.scene, NULL) >= 0);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        SCENE_REFUSES(matc_scene_add_mesh(of.scene, &wrong[i]) >= 0);
}

static void wrong_scene_add_object(void)
{
    static const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const MatcMesh triangle = {sizeof triangle, positions, NULL, NULL, NULL, 3, 0};
    const int mesh = matc_scene_add_mesh(of.scene, &triangle);
    const double flat[16] = {1, [15] = 1}, none[16] = {NAN},
                 projective[16] = {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    assert_int_equal(mesh, 0);
    assert_int_equal(matc_scene_add_object(NULL, mesh, 0, identity), -1);
    SCENE_REFUSES(matc_scene_add_object(of.scene, mesh, 0, NULL) >= 0);
    SCENE_REFUSES(matc_scene_add_object(of.scene, mesh, 0, flat) >= 0);
    SCENE_REFUSES(matc_scene_add_object(of.scene, mesh, 0, none) >= 0);
    SCENE_REFUSES(matc_scene_add_object(of.scene, mesh, 0, projective) >= 0);
    for (int i = 0; i < OUTSIDE; i++) {
        SCENE_REFUSES(matc_scene_add_object(of.scene, outside[i], 0, identity) >= 0);
        SCENE_REFUSES(matc_scene_add_object(of.scene, mesh, outside[i], identity) >= 0);
    }
}

static void wrong_scene_remove_object(void)
{
    assert_false(matc_scene_remove_object(NULL, 0));
    for (int i = 0; i < OUTSIDE; i++)
        SCENE_REFUSES(matc_scene_remove_object(of.scene, outside[i]));
}

static void wrong_scene_set_visible(void)
{
    assert_false(matc_scene_set_visible(NULL, 0, false));
    for (int i = 0; i < OUTSIDE; i++)
        SCENE_REFUSES(matc_scene_set_visible(of.scene, outside[i], false));
}

/* -- renderers */

static void wrong_renderer_open(void)
{
    const MatcOptions unset = {.validate = true};
    const MatcRendererOptions wrong[] = {
        {.load = load, .user = of.owner},
        /* a caller that knows no member */
        {.size = sizeof(size_t), .load = load, .user = of.owner},
        {.size = sizeof(MatcRendererOptions)},
        {.size = sizeof(MatcRendererOptions), .load = load_nothing},
        {.size = sizeof(MatcRendererOptions), .load = load, .user = of.owner, .view = ""},
        {.size = sizeof(MatcRendererOptions), .load = load, .user = of.owner, .view = "picture"},
        {.size = sizeof(MatcRendererOptions), .load = load, .user = of.owner, .compile = &unset},
        {.size = sizeof(MatcRendererOptions), .load = load, .user = of.owner, .width = -1},
        {.size = sizeof(MatcRendererOptions), .load = load, .user = of.owner, .height = INT_MAX},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char error[MESSAGE] = "";
        assert_null(matc_renderer_open(&wrong[i], error, sizeof error));
        assert_true(*error);
        /* room for the terminating zero alone */
        assert_null(matc_renderer_open(&wrong[i], error, 1));
        assert_int_equal(*error, 0);
        assert_null(matc_renderer_open(&wrong[i], NULL, 0));
    }
    char error[MESSAGE] = "";
    assert_null(matc_renderer_open(NULL, error, sizeof error));
    assert_string_equal(error, "the options are NULL");
}

static void wrong_renderer_close(void) { matc_renderer_close(NULL); }
static void wrong_renderer_error(void)
{
    assert_string_equal(matc_renderer_error(NULL), "the renderer is NULL");
}

static void wrong_renderer_set_scene(void)
{
    assert_false(matc_renderer_set_scene(NULL, of.scene));
    RENDER_REFUSES(matc_renderer_set_scene(of.render, NULL));
}

static void wrong_renderer_set_object(void)
{
    const double none[16] = {INFINITY};
    assert_false(matc_renderer_set_object(NULL, 0, identity));
    EMPTY_REFUSES(matc_renderer_set_object(of.empty, 0, identity));
    RENDER_REFUSES(matc_renderer_set_object(of.render, 0, NULL));
    RENDER_REFUSES(matc_renderer_set_object(of.render, 0, none));
    for (int i = 0; i < OUTSIDE; i++)
        RENDER_REFUSES(matc_renderer_set_object(of.render, outside[i], identity));
}

static void wrong_renderer_set_camera(void)
{
    const double from[3] = {0, -5, 1}, up[3] = {0, 0, 1}, none[3] = {0, NAN, 0},
                 far_off[3] = {0, 0, INFINITY};
    assert_false(matc_renderer_set_camera(NULL, from, origin, up));
    EMPTY_REFUSES(matc_renderer_set_camera(of.empty, from, origin, up));
    RENDER_REFUSES(matc_renderer_set_camera(of.render, NULL, origin, up));
    RENDER_REFUSES(matc_renderer_set_camera(of.render, from, NULL, up));
    RENDER_REFUSES(matc_renderer_set_camera(of.render, from, origin, NULL));
    RENDER_REFUSES(matc_renderer_set_camera(of.render, none, origin, up));
    RENDER_REFUSES(matc_renderer_set_camera(of.render, from, far_off, up));
    RENDER_REFUSES(matc_renderer_set_camera(of.render, from, origin, none));
    RENDER_REFUSES(
        matc_renderer_set_camera(of.render, from, origin, origin)); /* up has no direction */
    RENDER_REFUSES(matc_renderer_set_camera(of.render, from, from, up));
    RENDER_REFUSES(matc_renderer_set_camera(of.render, up, origin, up));
}

static void wrong_renderer_set_light(void)
{
    const double none[3] = {NAN, 0, 0};
    assert_false(matc_renderer_set_light(NULL, 0, origin, origin));
    EMPTY_REFUSES(matc_renderer_set_light(of.empty, 0, origin, origin));
    RENDER_REFUSES(matc_renderer_set_light(of.render, 0, NULL, origin));
    RENDER_REFUSES(matc_renderer_set_light(of.render, 0, origin, NULL));
    RENDER_REFUSES(matc_renderer_set_light(of.render, 0, none, origin));
    RENDER_REFUSES(matc_renderer_set_light(of.render, 0, origin, none));
    for (int i = 0; i < OUTSIDE; i++)
        RENDER_REFUSES(matc_renderer_set_light(of.render, outside[i], origin, origin));
}

static void wrong_renderer_set_shadows(void)
{
    assert_false(matc_renderer_set_shadows(NULL, 0, "map"));
    EMPTY_REFUSES(matc_renderer_set_shadows(of.empty, 0, "map"));
    RENDER_REFUSES(matc_renderer_set_shadows(of.render, 0, NULL));
    RENDER_REFUSES(matc_renderer_set_shadows(of.render, 0, ""));
    RENDER_REFUSES(matc_renderer_set_shadows(of.render, 0, "maps"));
    for (int i = 0; i < OUTSIDE; i++)
        RENDER_REFUSES(matc_renderer_set_shadows(of.render, outside[i], "map"));
}

static void wrong_renderer_set_param(void)
{
    const float components[5] = {0}, none[3] = {0, NAN, 0};
    static const int counts[] = {0, -1, 1, 2, 4, 5, INT_MAX, INT_MIN};
    assert_false(matc_renderer_set_param(NULL, 0, "paint", components, 3));
    EMPTY_REFUSES(matc_renderer_set_param(of.empty, 0, "paint", components, 3));
    RENDER_REFUSES(matc_renderer_set_param(of.render, 0, NULL, components, 3));
    RENDER_REFUSES(matc_renderer_set_param(of.render, 0, "paints", components, 3));
    RENDER_REFUSES(matc_renderer_set_param(of.render, 0, "paint", NULL, 3));
    RENDER_REFUSES(matc_renderer_set_param(of.render, 0, "paint", none, 3));
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++)
        RENDER_REFUSES(matc_renderer_set_param(of.render, 0, "paint", components, counts[i]));
    for (int i = 0; i < OUTSIDE; i++)
        RENDER_REFUSES(matc_renderer_set_param(of.render, outside[i], "paint", components, 3));
}

static void wrong_renderer_set_perspective(void)
{
    static const double angles[] = {0, -1, 180, 1e9, NAN, INFINITY},
                        nears[] = {0, -1, NAN, INFINITY};
    assert_false(matc_renderer_set_perspective(NULL, 40, 1));
    EMPTY_REFUSES(matc_renderer_set_perspective(of.empty, 40, 1));
    for (size_t i = 0; i < sizeof angles / sizeof *angles; i++)
        RENDER_REFUSES(matc_renderer_set_perspective(of.render, angles[i], 1));
    for (size_t i = 0; i < sizeof nears / sizeof *nears; i++)
        RENDER_REFUSES(matc_renderer_set_perspective(of.render, 40, nears[i]));
}

static void wrong_renderer_set_orthographic(void)
{
    static const double lengths[] = {0, -1, NAN, INFINITY};
    assert_false(matc_renderer_set_orthographic(NULL, 1, 1));
    EMPTY_REFUSES(matc_renderer_set_orthographic(of.empty, 1, 1));
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        RENDER_REFUSES(matc_renderer_set_orthographic(of.render, lengths[i], 1));
        RENDER_REFUSES(matc_renderer_set_orthographic(of.render, 1, lengths[i]));
    }
}

static void wrong_renderer_set_time(void)
{
    assert_false(matc_renderer_set_time(NULL, 0));
    EMPTY_REFUSES(matc_renderer_set_time(of.empty, 0));
    RENDER_REFUSES(matc_renderer_set_time(of.render, NAN));
    RENDER_REFUSES(matc_renderer_set_time(of.render, -INFINITY));
}

static void wrong_renderer_set_size(void)
{
    static const int sides[] = {-1, 16385, INT_MAX, INT_MIN};
    assert_false(matc_renderer_set_size(NULL, 8, 8));
    for (size_t i = 0; i < sizeof sides / sizeof *sides; i++) {
        RENDER_REFUSES(matc_renderer_set_size(of.render, sides[i], 8));
        RENDER_REFUSES(matc_renderer_set_size(of.render, 8, sides[i]));
    }
}

static void wrong_renderer_update(void)
{
    assert_false(matc_renderer_update(NULL));
    EMPTY_REFUSES(matc_renderer_update(of.empty));
}

static void wrong_renderer_draw(void)
{
    static const int whole[4] = {0, 0, WIDTH, HEIGHT},
                     wrong[][4] = {{0, 0, 0, 8},       {0, 0, 8, 0},       {0, 0, -8, 8},
                                   {INT_MIN, 0, 8, 8}, {0, INT_MAX, 8, 8}, {0, 0, INT_MAX, 8},
                                   {0, 0, 8, INT_MAX}};
    assert_false(matc_renderer_draw(NULL, 0, whole));
    EMPTY_REFUSES(matc_renderer_draw(of.empty, 0, whole));
    RENDER_REFUSES(matc_renderer_draw(of.render, 0, NULL));
    /* the context has no such framebuffer */
    RENDER_REFUSES(matc_renderer_draw(of.render, 999, whole));
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        RENDER_REFUSES(matc_renderer_draw(of.render, 0, wrong[i]));
}

static void wrong_renderer_frame(void)
{
    assert_false(matc_renderer_frame(NULL));
    EMPTY_REFUSES(matc_renderer_frame(of.empty));
}

static void wrong_renderer_width(void)
{
    assert_int_equal(matc_renderer_width(NULL) + matc_renderer_width(of.empty), 0);
}
static void wrong_renderer_height(void)
{
    assert_int_equal(matc_renderer_height(NULL) + matc_renderer_height(of.empty), 0);
}
static void wrong_renderer_texture(void)
{
    assert_int_equal(matc_renderer_texture(NULL) + matc_renderer_texture(of.empty), 0);
}

static void wrong_renderer_read(void)
{
    float floats[4];
    assert_false(matc_renderer_read(NULL, floats));
    EMPTY_REFUSES(matc_renderer_read(of.empty, floats));
    RENDER_REFUSES(matc_renderer_read(of.render, NULL));
}

#define ROW(name)                                                                                  \
    {                                                                                              \
        "matc_" #name, wrong_##name                                                                \
    }
static const ApiRow rows[] = {
    ROW(scene_read),
    ROW(scene_free),
    ROW(scene_object_count),
    ROW(scene_light_count),
    ROW(scene_material_count),
    ROW(scene_matrix),
    ROW(scene_error),
    ROW(scene_object_name),
    ROW(scene_find_object),
    ROW(scene_find_light),
    ROW(scene_find_material),
    ROW(scene_add_mesh),
    ROW(scene_add_object),
    ROW(scene_remove_object),
    ROW(scene_set_visible),
    ROW(renderer_open),
    ROW(renderer_close),
    ROW(renderer_error),
    ROW(renderer_set_scene),
    ROW(renderer_set_object),
    ROW(renderer_set_camera),
    ROW(renderer_set_light),
    ROW(renderer_set_shadows),
    ROW(renderer_set_param),
    ROW(renderer_set_perspective),
    ROW(renderer_set_orthographic),
    ROW(renderer_set_time),
    ROW(renderer_set_size),
    ROW(renderer_update),
    ROW(renderer_draw),
    ROW(renderer_frame),
    ROW(renderer_width),
    ROW(renderer_height),
    ROW(renderer_texture),
    ROW(renderer_read),
};

static void wrong_arguments_of_every_function(void **state)
{
    (void)state;
    float after[FLOATS];
    api_rows_run("runtime/renderer/matc_render.h", rows, sizeof rows / sizeof *rows);
    assert_true(matc_renderer_update(of.render) && matc_renderer_frame(of.render) &&
                matc_renderer_read(of.render, after));
    assert_memory_equal(after, of.before, sizeof after);
}

/* A scene with displaced objects refuses further meshes, objects and materials, and still draws. */
static void displaced_scenes_take_no_more(void **state)
{
    (void)state;
    static const char displaced[] =
        "displacement: { triangles: 2000 }\nmaterials:\n"
        "  rock: { material: Phong, displacementScale: .1, displacement: { map: Granite } }\n"
        "  spare: { material: Phong }\n"
        "objects: [{ object: Sphere, material: rock }]\n";
    static const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const MatcMesh triangle = {sizeof triangle, positions, NULL, NULL, NULL, 3, 0};
    MatcDocument *document;
    MatcScene *scene = matc_scene_read("a.yaml", displaced, strlen(displaced), NULL, &document);
    assert_non_null(scene);
    assert_int_equal(matc_scene_add_mesh(scene, &triangle), -1);
    assert_string_equal(matc_scene_error(scene),
                        "a scene with displaced objects takes no further meshes");
    assert_int_equal(matc_scene_add_object(scene, 0, 0, identity), -1);
    assert_string_equal(matc_scene_error(scene),
                        "a scene with displaced objects takes no further objects");
    assert_int_equal(matc_scene_find_material(scene, "rock"), 0);
    assert_int_equal(matc_scene_find_material(scene, "spare"), -1);
    assert_string_equal(matc_scene_error(scene),
                        "a scene with displaced objects takes no further materials");
    assert_int_equal(matc_scene_object_count(scene), 1);
    matc_scene_free(scene);
    matc_document_free(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(wrong_arguments_of_every_function, open_all, close_all),
        cmocka_unit_test(displaced_scenes_take_no_more)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
