/* The GL layer on a software driver: contexts, framebuffers, programs in every GLSL version,
 * error messages. test_gl egl: by EGL; exit status 77 without EGL. */
#include "tests/test.h"
#include "runtime/gl/framebuffer.h"
#include "runtime/gl/mesh.h"
#include "runtime/gl/texture.h"
#include "tests/gl_texts.h"
#include <string.h>

static void context_opens(void **state)
{
    (void)state;
    for (int core = 0; core < 2; core++) {
        GlContext *gl = open_context(core);
        print_message("%s: GL %s; GLSL %s; %s; %d texels, %d units, %d targets\n",
                      core ? "core" : "compatibility", gl->version, gl->language, gl->renderer,
                      gl->max_texture_size, gl->max_texture_units, gl->max_draw_buffers);
        assert_true(gl->major > 3 || (gl->major == 3 && gl->minor >= 3) || !core);
        gl_close(gl);
    }
    char error[64] = "";
    assert_null(gl_open(GL_KIND_count, true, error, sizeof error));
    assert_string_equal(error, "unknown kind of GL context");
}

static void two_contexts_take_turns(void **state)
{
    (void)state;
    GlContext *first = open_context(true), *second = open_context(false);
    assert_true(gl_use(first));
    GLuint program = first->CreateProgram();
    assert_true(gl_use(second));
    assert_true(gl_use(first));
    first->DeleteProgram(program);
    assert_true(gl_check(first, "taking turns"));
    gl_close(first);
    gl_close(second);
}

static GLuint make_program(GlContext *gl, const Language *language)
{
    static const char *const outputs[] = {"first", "second"};
    GLuint program = program_make(gl, &(ProgramText){.vertex = {language->vertex},
                                                     .fragment = {language->fragment},
                                                     .outputs = outputs,
                                                     .output_count = 2});
    if (!program)
        fail_msg("%s", gl->error);
    return program;
}

/* Half floats keep these numbers exactly; outside of [0, 1] nothing is clamped; the plane is met at
 * its middle. */
static void draw_constant(GlContext *gl, GLuint program, GLenum format)
{
    const float value[4] = {-3.5f, 0.25f, 1000, 1};
    Framebuffer target;
    Mesh plane;
    float texels[5 * 3 * 4];
    assert_true(framebuffer_make(gl, &(FramebufferSpec){5, 3, 2, format, true}, &target));
    assert_true(mesh_make(gl, SHAPE_plane, &plane));
    assert_true(set(gl, program, "value", value));
    gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    mesh_draw(gl, &plane);
    for (int color = 0; color < 2; color++) {
        assert_true(framebuffer_read(gl, &target, color, texels));
        for (int i = 0; i < 5 * 3 * 4; i++)
            assert_true(texels[i] == (float)(color + 1) * value[i % 4]);
    }
    assert_false(framebuffer_read(gl, &target, 2, texels));
    mesh_delete(gl, &plane);
    framebuffer_delete(gl, &target);
}

static void every_language_draws(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof languages / sizeof *languages; i++) {
        GlContext *gl = open_context(languages[i].core);
        GLuint program = make_program(gl, &languages[i]);
        draw_constant(gl, program, GL_RGBA32F);
        draw_constant(gl, program, GL_RGBA16F);
        assert_false(set(gl, program, "absent", &(float){1}));
        assert_true(gl_check(gl, "drawing"));
        gl->DeleteProgram(program);
        gl_close(gl);
    }
}

/* EGL does the same; it and OSMesa get on in one process. */
static void egl_draws(void **state)
{
    (void)state;
    char error[512] = "";
    GlContext *first = open_context(true);
    for (size_t i = 0; i < sizeof languages / sizeof *languages; i++) {
        GlContext *gl = gl_open(GL_KIND_egl, languages[i].core, error, sizeof error);
        if (!gl)
            fail_msg("%s", error);
        GLuint program = make_program(gl, &languages[i]);
        draw_constant(gl, program, GL_RGBA32F);
        gl_close(gl);
    }
    assert_true(gl_use(first));
    GLuint program = make_program(first, &languages[1]);
    draw_constant(first, program, GL_RGBA32F);
    gl_close(first);
}

static void egl_contexts_take_turns(void **state)
{
    (void)state;
    char error[512] = "";
    GlContext *first = gl_open(GL_KIND_egl, true, error, sizeof error);
    GlContext *second = gl_open(GL_KIND_egl, false, error, sizeof error);
    if (!first || !second)
        fail_msg("%s", error);
    print_message("EGL: %s; %s; %s\n", first->version, first->renderer,
                  first->hardware ? "hardware" : "software");
    assert_true(gl_use(first));
    GLuint program = first->CreateProgram();
    gl_close(second); /* not the current one, and on the same display */
    first->DeleteProgram(program);
    assert_true(gl_check(first, "outliving another"));
    gl_close(first);
}

static void kinds_have_names(void **state)
{
    (void)state;
    GlKind kind = GL_KIND_count;
    for (int i = 0; i < GL_KIND_count; i++)
        assert_true(gl_kind_find(gl_kind_name((GlKind)i), &kind) && (int)kind == i);
    assert_false(gl_kind_find("glx", &kind));
}

static void faults_are_reported(void **state)
{
    (void)state;
    GlContext *gl = open_context(true);
    const char *good = languages[1].vertex;
    assert_int_equal(
        program_make(gl,
                     &(ProgramText){.vertex = {good},
                                    .fragment = {"#version 330 core\nvoid main() { x = 1.; }"}}),
        0);
    assert_int_equal(strncmp(gl->error, "fragment: ", 10), 0);
    assert_non_null(strstr(gl->error, "x"));
    assert_int_equal(program_make(gl, &(ProgramText){.vertex = {good}}), 0);
    assert_string_equal(gl->error, "fragment: no text");
    const char *undefined =
        "#version 330 core\nout vec4 c; float f(); void main() { c = vec4(f()); }";
    assert_int_equal(program_make(gl, &(ProgramText){.vertex = {good}, .fragment = {undefined}}),
                     0);
    assert_int_equal(strncmp(gl->error, "link: ", 6), 0);
    Framebuffer none;
    assert_false(framebuffer_make(gl, &(FramebufferSpec){0, 4, 1, GL_RGBA8, false}, &none));
    assert_false(framebuffer_make(gl, &(FramebufferSpec){1 << 20, 4, 1, GL_RGBA8, false}, &none));
    assert_false(framebuffer_make(gl, &(FramebufferSpec){4, 4, 1, GL_RGB9_E5, false}, &none));
    assert_int_equal(none.name, 0);
    assert_int_equal(
        texture_make(
            gl,
            &(TextureSpec){.width = 2, .height = 2, .components = 3, .bytes = (uint8_t[12]){0}}),
        0);
    assert_int_equal(texture_make(gl, &(TextureSpec){.width = 2, .height = 2, .components = 4}), 0);
    assert_true(gl_check(gl, "refusing"));
    gl_close(gl);
}

static void depth_only_is_complete(void **state)
{
    (void)state;
    GlContext *gl = open_context(true);
    Framebuffer depth;
    assert_true(framebuffer_make(gl, &(FramebufferSpec){4, 4, 0, GL_NONE, true}, &depth));
    framebuffer_delete(gl, &depth);
    gl_close(gl);
}

int main(int count, char **arguments)
{
    const struct CMUnitTest egl[] = {cmocka_unit_test(egl_draws),
                                     cmocka_unit_test(egl_contexts_take_turns)};
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(context_opens),        cmocka_unit_test(two_contexts_take_turns),
        cmocka_unit_test(every_language_draws), cmocka_unit_test(kinds_have_names),
        cmocka_unit_test(faults_are_reported),  cmocka_unit_test(depth_only_is_complete),
    };
    if (count < 2 || strcmp(arguments[1], "egl") != 0)
        return cmocka_run_group_tests(tests, NULL, NULL);
    return has_egl() ? cmocka_run_group_tests(egl, NULL, NULL) : SKIPPED;
}
