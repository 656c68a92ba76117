/* Grouped far lights combined with the renderer's other features: their memory, drivers with too
 * little of it, changes, tiles, edges, layouts. test_frame_lights.c checks their error bound. */
/* ctest: seconds=19 */
#include "tests/test.h"
#include "tests/frame/frame_change.h"
#include "tests/frame/frame_lamps.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 72, HEIGHT = 100, PIXELS = WIDTH * HEIGHT, LIGHTS = 300 };

static const FrameLamps hall = {
    "a hall",
    FRAME_LAMPS_CAMERA "objects: [" FRAME_LAMPS_FLOOR(
        "diffuse: [.6, .5, .4], specular: .2, shininess: .8") ", { object: Sphere, "
                                                              "material: { material: "
                                                              "Phong, diffuse: .7 } }]\n",
    "Point",
    LIGHTS,
    .3,
    2,
    4,
    20,
    1};

typedef struct {
    MatcOptions compile;
    GlContext *gl;
    MatcDocument *document;
    Scene *scene;
} Hall;

static Hall open_lamps(const FrameLamps *lamps)
{
    Hall h = {.compile = frame_exact_options(), .gl = frame_context()};
    char *text = frame_lamps_text(lamps, WIDTH, HEIGHT);
    h.scene = frame_scene(text, &h.compile, &h.document);
    free(text);
    return h;
}

static Hall open_hall(void) { return open_lamps(&hall); }

static void close_hall(Hall *h)
{
    assert_true(gl_check(h->gl, "a hall"));
    gl_close(h->gl);
    frame_forget(h->scene, h->document);
}

static Renderer *open_renderer(const Hall *h, const RendererOptions *options)
{
    Renderer *renderer = renderer_open(h->gl, options);
    assert_true(renderer && renderer_set_scene(renderer, h->scene));
    return renderer;
}

/* -- memory */

static void (*driver_buffer_data)(GLenum target, GLsizeiptr size, const void *data, GLenum usage);
static size_t storage_bytes; /* of all storage buffers that were made */

static void count_buffer_data(GLenum target, GLsizeiptr size, const void *data, GLenum usage)
{
    storage_bytes += target == GL_SHADER_STORAGE_BUFFER ? (size_t)size : 0;
    driver_buffer_data(target, size, data, usage);
}

/* The memory allocated by the driver equals that printed by --stats, by which tiles are planned. */
static void buffers_are_counted(void **state)
{
    (void)state;
    static const size_t memories[] = {0, 1, WIDTH * 60 * 45, WIDTH * 40 * 45, WIDTH * 33 * 40};
    Hall h = open_hall();
    driver_buffer_data = h.gl->BufferData;
    h.gl->BufferData = count_buffer_data;
    Renderer *all = open_renderer(&h, &(RendererOptions){.compile = &h.compile, .lights = "all"});
    const int others = renderer_pixel_bytes(all);
    const size_t before = storage_bytes;
    renderer_close(all);
    for (size_t i = 0; i < sizeof memories / sizeof *memories; i++) {
        storage_bytes = 0;
        Renderer *renderer =
            open_renderer(&h, &(RendererOptions){.compile = &h.compile, .memory = memories[i]});
        const size_t pixels =
            (size_t)renderer_tile_width(renderer) * (size_t)renderer_tile_height(renderer);
        const size_t bytes = storage_bytes - before;
        assert_true(bytes > 2 * pixels); /* they are there */
        assert_int_equal(renderer_pixel_bytes(renderer), others + 4);
        if (renderer_tile_height(renderer) > RENDERER_TILE_MIN)
            assert_true(others * pixels + bytes <= (memories[i] ? memories[i] : RENDERER_MEMORY));
        char *graph = frame_graph(renderer), reported[128];
        snprintf(reported, sizeof reported,
                 "\nfar two buffers 4: %zu bytes for blocks of 32 x 32\n", bytes);
        assert_non_null(strstr(graph, reported));
        free(graph);
        renderer_close(renderer);
    }
    close_hall(&h);
}

/* -- drivers with less */

static GLenum scarce;
static GLint least;
static void (*driver_get)(GLenum name, GLint *value);

static void get_less(GLenum name, GLint *value)
{
    driver_get(name, value);
    if (name == scarce)
        *value = least;
}

/* If programs may have too few storage buffers, or textures, all lights are summed; if buffers
 * are too small, tiles are lower. */
static void drivers_with_less(void **state)
{
    (void)state;
    static const struct {
        GLenum name;
        GLint most;
        bool enough;
    } cases[] = {{GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, 2, false},
                 {GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, 3, true},
                 {GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, 5, false},
                 {GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, 6, true},
                 {GL_MAX_COMPUTE_TEXTURE_IMAGE_UNITS, 17, false},
                 {GL_MAX_COMPUTE_TEXTURE_IMAGE_UNITS, 18, true}};
    Hall h = open_hall();
    RendererOptions options = {.compile = &h.compile, .view = "light", .lights = "all"};
    float *all = frame_floats(h.gl, h.scene, &options);
    driver_get = h.gl->GetIntegerv;
    h.gl->GetIntegerv = get_less;
    options.lights = "bounded";
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        scarce = cases[i].name;
        least = cases[i].most;
        float *drawn = frame_floats(h.gl, h.scene, &options);
        assert_int_equal(memcmp(all, drawn, PIXELS * 4 * sizeof *all) != 0, cases[i].enough);
        free(drawn);
    }
    scarce = GL_MAX_SHADER_STORAGE_BLOCK_SIZE;
    least =
        /* numbers of a block are 4 * 43 * 4 floats; three blocks are across, not quite three
         * along */
        3 * 3 * 2752 - 1;
    Renderer *renderer = open_renderer(&h, &options);
    assert_int_equal(renderer_tile_height(renderer), 2 * 32);
    renderer_close(renderer);
    scarce = GL_MAX_TEXTURE_BUFFER_SIZE;
    least = 3 * 3 * (64 + 4 * (17 + 16)) - 1; /* words of a block, more than its 172 texels */
    renderer = open_renderer(&h, &options);
    assert_int_equal(renderer_tile_height(renderer), 2 * 32);
    renderer_close(renderer);
    free(all);
    close_hall(&h);
}

/* -- what else a renderer does */

static const double half_step = 1. / 510;

/* Greatest distance of a component in two pictures of light as displayed, in half steps; differ:
 * how many components differ. */
static double most_apart(const float *a, const float *b, int *differ)
{
    double most = 0;
    *differ = 0;
    for (int i = 0; i < PIXELS * 4; i++) {
        most = fmax(most, fabs(frame_lamps_shown(SCENE_Clamp, 1, a[i]) -
                               frame_lamps_shown(SCENE_Clamp, 1, b[i])));
        *differ += a[i] != b[i];
    }
    return most / half_step;
}

/* The picture equals that of a new renderer, bit for bit. */
static void expect_as_new(const Hall *h, Renderer *renderer, const RendererOptions *options)
{
    float *changed = frame_change_next(renderer);
    GlContext *gl = frame_context();
    float *new = frame_floats(gl, h->scene, options);
    assert_memory_equal(changed, new, PIXELS * 4 * sizeof *new);
    gl_close(gl);
    assert_true(gl_use(h->gl));
    free(changed);
    free(new);
}

static void changes(void **state)
{
    (void)state;
    Hall h = open_hall();
    const RendererOptions options = {.compile = &h.compile, .view = "light", .lights = "bounded"};
    Renderer *renderer = open_renderer(&h, &options);
    float *before = frame_change_next(renderer);
    h.scene->camera.position[0] += 1;
    assert_true(renderer_changed(renderer, RENDERER_CAMERA));
    expect_as_new(&h, renderer, &options);
    h.scene->lights[3].position[2] += 1;
    h.scene->lights[LIGHTS - 1].light[1] *= 90;
    assert_true(renderer_changed(renderer, RENDERER_LIGHTS));
    expect_as_new(&h, renderer, &options);
    float *after = frame_change_next(renderer);
    assert_memory_not_equal(before, after, PIXELS * 4 * sizeof *after);
    free(before);
    free(after);
    renderer_close(renderer);
    close_hall(&h);
}

/* Tiles whose blocks differ from the picture's. A wall that faces the eye has the same depth in
 * all tiles: test_tiles.c. */
static void tiles(void **state)
{
    (void)state;
    static const int sizes[][2] = {{WIDTH, 34}, {26, HEIGHT}, {14, 62}};
    static const FrameLamps wall = {
        "a wall",
        "camera: { camera: Perspective, position: [0, 0, 6], target: [0, 0, 0], up: [0, 1, "
        "0] }\nobjects: [" FRAME_LAMPS_FLOOR("diffuse: .5, specular: .3") "]\n",
        "Point",
        LIGHTS,
        .3,
        2,
        4,
        20,
        1};
    Hall h = open_lamps(&wall);
    RendererOptions options = {.compile = &h.compile, .view = "light", .lights = "all"};
    int differ;
    float *all = frame_floats(h.gl, h.scene, &options);
    options.lights = "bounded";
    float *whole = frame_floats(h.gl, h.scene, &options);
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        memcpy(options.tile, sizes[i], sizeof options.tile);
        float *drawn = frame_tiles(h.gl, h.scene, &options);
        assert_true(most_apart(all, drawn, &differ) <= 1 && differ > PIXELS / 10);
        assert_true(most_apart(whole, drawn, &differ) <= 1 && differ > PIXELS / 10);
        free(drawn);
    }
    free(all);
    free(whole);
    close_hall(&h);
}

/* Other layouts than floats, of which test_frame_lights.c is: what is read there is the same for
 * both sums. And groups that have as many invocations as a GPU gives them. */
static void layouts(void **state)
{
    (void)state;
    static const struct {
        const char *layout;
        bool hardware;
    } cases[] = {{NULL, false}, {"integer", false}, {"compact", false}, {"integer", true}};
    Hall h = open_hall();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        int differ;
        h.compile.layout = cases[i].layout;
        h.gl->hardware = cases[i].hardware;
        RendererOptions options = {.compile = &h.compile, .view = "light", .lights = "all"};
        float *all = frame_floats(h.gl, h.scene, &options);
        options.lights = "bounded";
        float *drawn = frame_floats(h.gl, h.scene, &options);
        const double most = most_apart(all, drawn, &differ);
        print_message("%-8s %4.2f of half a step, %d components differ\n",
                      cases[i].layout ? cases[i].layout : "default", most, differ);
        assert_true(most <= 1 && differ > 20); /* light as halves rounds most of it off */
        free(all);
        free(drawn);
    }
    close_hall(&h);
}

/* A blend of two pixels is within the bound of both, for a picture of 16 bits, whose own steps
 * are added. */
static void edges(void **state)
{
    (void)state;
    Hall h = open_hall();
    RendererOptions options = {
        .compile = &h.compile, .deep = true, .edges = RENDERER_EDGES_coverage, .lights = "all"};
    float *all = frame_floats(h.gl, h.scene, &options);
    options.lights = "bounded";
    float *drawn = frame_floats(h.gl, h.scene, &options);
    options.edges = RENDERER_EDGES_none;
    float *hard = frame_floats(h.gl, h.scene, &options);
    int differ = 0, blended = 0;
    for (int i = 0; i < 4 * PIXELS; i++) {
        assert_true(fabs((double)all[i] - (double)drawn[i]) <= half_step + 1. / 65535);
        differ += all[i] != drawn[i];
        blended += fabs((double)hard[i] - (double)drawn[i]) > .01;
    }
    assert_true(differ > 20 && blended > 30);
    free(all);
    free(drawn);
    free(hard);
    close_hall(&h);
}

/* Boxes so small that a block of pixels contains the floor and three of their sides: each has
 * separate sums. */
static void sides_of_boxes(void **state)
{
    (void)state;
    static const FrameLamps boxes = {
        "boxes",
        "camera: { camera: Perspective, position: [3, -8, 6], target: [0, 0, 0] }\nobjects: "
        "[" FRAME_LAMPS_FLOOR(
            "diffuse: .5") ", { object: Scatter, count: 400, size: [9, 9, 0], seed: 2, objects: [{ "
                           "object: Box, "
                           "size: [.2, .2, .3], material: { material: Phong, diffuse: .7 } }] }]\n",
        "Point",
        LIGHTS,
        3,
        5,
        6,
        9,
        1};
    Hall h = open_lamps(&boxes);
    int differ;
    RendererOptions options = {.compile = &h.compile, .view = "light", .lights = "all"};
    float *all = frame_floats(h.gl, h.scene, &options);
    options.lights = "bounded";
    float *drawn = frame_floats(h.gl, h.scene, &options);
    const double most = most_apart(all, drawn, &differ);
    print_message("boxes: %4.2f of half a step, %d components differ\n", most, differ);
    assert_true(most <= 1 && differ > 14500); /* 13292 with two groups in a block */
    free(all);
    free(drawn);
    close_hall(&h);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(buffers_are_counted),
                                       cmocka_unit_test(drivers_with_less),
                                       cmocka_unit_test(changes),
                                       cmocka_unit_test(tiles),
                                       cmocka_unit_test(layouts),
                                       cmocka_unit_test(edges),
                                       cmocka_unit_test(sides_of_boxes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
