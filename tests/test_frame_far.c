/* Far lights that are taken together, beside all that a renderer does otherwise: their memory, drivers that have too little for them, changes, tiles, edges,
 * layouts. That they are within their bound at all is test_frame_lights.c's. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/frame/frame_draw.h"
#include "tests/frame/frame_lamps.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 72, HEIGHT = 100, PIXELS = WIDTH * HEIGHT, LIGHTS = 300 };

static const FrameLamps hall = {"a hall",
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

static Hall open_hall(void)
{
    Hall h = {.compile = frame_exact_options(), .gl = frame_context()};
    char *text = frame_lamps_text(&hall, WIDTH, HEIGHT);
    h.scene = frame_scene(text, &h.compile, &h.document);
    free(text);
    return h;
}

static void close_hall(Hall *h)
{
    assert_true(gl_check(h->gl, "a hall"));
    gl_close(h->gl);
    frame_forget(h->scene, h->document);
}

static Render *open_render(const Hall *h, const RenderOptions *options)
{
    Render *render = render_open(h->gl, options);
    assert_true(render && render_scene(render, h->scene));
    return render;
}

/* -- memory */

static void (*driver_buffer_data)(GLenum target, GLsizeiptr size, const void *data, GLenum usage);
static size_t storage_bytes; /* of all storage buffers that were made */

static void count_buffer_data(GLenum target, GLsizeiptr size, const void *data, GLenum usage)
{
    storage_bytes += target == GL_SHADER_STORAGE_BUFFER ? (size_t)size : 0;
    driver_buffer_data(target, size, data, usage);
}

/* What the driver is asked for is what is said, and what tiles are made for. */
static void buffers_are_counted(void **state)
{
    (void)state;
    static const size_t memories[] = {0, 1, WIDTH * 60 * 45, WIDTH * 40 * 45, WIDTH * 33 * 40};
    Hall h = open_hall();
    driver_buffer_data = h.gl->BufferData;
    h.gl->BufferData = count_buffer_data;
    Render *all = open_render(&h, &(RenderOptions){.compile = &h.compile, .lights = "all"});
    const int others = render_pixel_bytes(all);
    const size_t before = storage_bytes;
    render_close(all);
    for (size_t i = 0; i < sizeof memories / sizeof *memories; i++) {
        storage_bytes = 0;
        Render *render = open_render(&h, &(RenderOptions){.compile = &h.compile, .memory = memories[i]});
        const size_t pixels = (size_t)render_tile_width(render) * (size_t)render_tile_height(render);
        const size_t bytes = storage_bytes - before;
        assert_true(bytes > 6 * pixels); /* they are there */
        assert_int_equal(render_pixel_bytes(render), others + 7);
        if (render_tile_height(render) > RENDER_TILE_LEAST)
            assert_true(others * pixels + bytes <= (memories[i] ? memories[i] : RENDER_MEMORY));
        char *graph = frame_graph(render), said[128];
        snprintf(said, sizeof said, "\nfar two buffers 7: %zu bytes for blocks of 16 x 16\n", bytes);
        assert_non_null(strstr(graph, said));
        free(graph);
        render_close(render);
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

/* Where a program may have too few storage buffers, all lights are summed; where a buffer may be too short, tiles are lower. */
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
                 {GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, 6, true}};
    Hall h = open_hall();
    RenderOptions options = {.compile = &h.compile, .view = "light", .lights = "all"};
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
        5 * 4 * 1064 - 1; /* words of a block are 8 + 2 (1 + 128); five blocks are across, and not quite four along */
    Render *render = open_render(&h, &options);
    assert_int_equal(render_tile_height(render), 3 * 16);
    render_close(render);
    free(all);
    close_hall(&h);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(buffers_are_counted), cmocka_unit_test(drivers_with_less)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
