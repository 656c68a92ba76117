/* No program that the renderer gives to the driver has an implicit derivative in non-uniform
 * control flow: glslang compiles the text to SPIR-V, whose blocks are walked. */
/* ctest: unsanitized */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include "tests/value/read_whole.h"
#include "tests/value/spirv_flow.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PROGRAM_CAPACITY = 1 << 20 };

static struct {
    void (*source)(GLuint, GLsizei, const GLchar *const *, const GLint *);
    char *text;
    int programs, derivatives, faults;
} driver;

static void take_source(GLuint shader, GLsizei count, const GLchar *const *pieces,
                        const GLint *lengths)
{
    int derivatives = 0;
    driver.text[0] = 0;
    for (int i = 0; i < count; i++)
        strncat(driver.text, pieces[i], PROGRAM_CAPACITY - strlen(driver.text) - 1);
    driver.source(shader, count, pieces, lengths);
    if (!strstr(driver.text, "dFd") && !strstr(driver.text, "fwidth") &&
        !strstr(driver.text, "texture("))
        return;
    const int conditional = glsl_conditional_derivatives(driver.text, &derivatives);
    driver.programs++;
    driver.derivatives += derivatives;
    driver.faults += conditional != 0;
    if (conditional)
        fprintf(stderr, "%.300s ...: %d implicit derivatives in conditions\n", driver.text,
                conditional);
}

/* A scene, small. */
static void draw_scene(const char *path, const char *text, RendererOptions *how)
{
    MatcOptions options;
    matc_options_init(&options);
    options.pixels = true;
    how->compile = &options;
    Scene *scene = NULL;
    MatcDocument *document = scene_read(path, text, strlen(text), &options, &scene);
    if (!scene)
        fail_msg("%s: %s", path, matc_diagnostics(document, MATC_TEXT));
    how->width = 48;
    how->height = 36;
    GlContext *gl = frame_context();
    driver.source = gl->ShaderSource;
    gl->ShaderSource = take_source;
    free(frame_floats(gl, scene, how));
    gl_close(gl);
    frame_forget(scene, document);
}

/* Glass in lists and peeled, with alpha tests; silhouette shadows and shadow volumes, which
 * store slopes; the positions view. */
static void renderer_derives_unconditionally(void **state)
{
    (void)state;
    static const char folder[] = SOURCE_FOLDER "/examples/scenes/";
    static const char hybrid[] =
        "materials: { m: { material: Phong } }\nlights: [{ light: Directional, shadows: hybrid }]\n"
        "objects: [{ object: Sphere, material: m }]\n";
    static const struct {
        const char *file, *view, *transparency;
    } rows[] = {{"glasses.yaml", "final", "lists"}, {"glasses.yaml", "final", "peeling"},
                {"window.yaml", "final", NULL},     {"window.yaml", "final", "peeling"},
                {"landscape.yaml", "final", NULL},  {"bush.yaml", "final", NULL},
                {"vase.yaml", "final", NULL},       {"solids.yaml", "positions", NULL},
                {"displaced.yaml", "final", NULL}};
    driver.text = malloc(PROGRAM_CAPACITY);
    assert_non_null(driver.text);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char path[512];
        size_t size;
        snprintf(path, sizeof path, "%s%s", folder, rows[i].file);
        char *text = read_whole(path, &size);
        assert_non_null(text);
        draw_scene(path, text,
                   &(RendererOptions){.view = rows[i].view, .transparency = rows[i].transparency});
        free(text);
    }
    draw_scene("hybrid.yaml", hybrid, &(RendererOptions){.view = "volume"});
    free(driver.text);
    print_message("%d of the renderer's programs, %d implicit derivatives\n", driver.programs,
                  driver.derivatives);
    assert_true(driver.programs > 10 && driver.derivatives > 10);
    assert_int_equal(driver.faults, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(renderer_derives_unconditionally)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
