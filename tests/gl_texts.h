/* Helpers of the GL layer's tests: a software context, programs in every GLSL version that the
 * context accepts, and their uniforms. */
#ifndef TESTS_GL_TEXTS_H
#define TESTS_GL_TEXTS_H
#include "runtime/gl/context.h"
#include "runtime/gl/program.h"
#include "runtime/gl/uniforms.h"
#include <stdio.h>

static inline GlContext *open_context(bool core)
{
    char error[512] = "";
    GlContext *gl = gl_open(GL_KIND_osmesa, core, error, sizeof error);
    if (!gl)
        fail_msg("%s", error);
    return gl;
}

/* Exit status of a test that needs EGL if EGL is missing. */
enum { SKIPPED = 77 };

static inline bool has_egl(void)
{
    char error[512] = "";
    GlContext *gl = gl_open(GL_KIND_egl, true, error, sizeof error);
    bool there = gl != NULL;
    if (!there)
        printf("SKIPPED: no EGL, so nothing was drawn by it: %s\n", error);
    gl_close(gl);
    return there;
}

/* A vertex and a fragment shader that write two targets: `value` and its double. */
typedef struct {
    bool core;
    const char *vertex, *fragment;
} Language;

static const Language languages[] = {
    {false, "attribute vec3 position; void main() { gl_Position = vec4(position, 1.); }",
     "#version 110\n#extension GL_ARB_draw_buffers : require\n"
     "uniform vec4 value; void main() { gl_FragData[0] = value; gl_FragData[1] = 2. * value; }"},
    {true,
     "#version 330 core\nlayout(location = 0) in vec3 position; void main() { gl_Position = "
     "vec4(position, 1.); }",
     "#version 330 core\nuniform vec4 value; layout(location = 0) out vec4 a; layout(location = 1) "
     "out vec4 b;"
     "void main() { a = value; b = 2. * value; }"},
    {true, "#version 330 core\nin vec3 position; void main() { gl_Position = vec4(position, 1.); }",
     "#version 330 core\nuniform vec4 value; out vec4 first; out vec4 second;"
     "void main() { first = value; second = 2. * value; }"},
    {true,
     "#version 450 core\nlayout(location = 0) in vec3 position; void main() { gl_Position = "
     "vec4(position, 1.); }",
     "#version 450 core\nlayout(location = 0) uniform vec4 value; layout(location = 0) out vec4 a; "
     "layout(location = "
     "1) out vec4 b;"
     "void main() { a = value; b = 2. * value; }"},
    {true,
     "#version 300 es\nlayout(location = 0) in vec3 position; void main() { gl_Position = "
     "vec4(position, 1.); }",
     "#version 300 es\nprecision highp float; uniform vec4 value;"
     "layout(location = 0) out vec4 a; layout(location = 1) out vec4 b; void main() { a = value; b "
     "= 2. * value; }"},
};

/* Sets a uniform of the current program; false if the program lacks it. */
static inline bool set(GlContext *gl, GLuint program, const char *name, const float *values)
{
    GlUniforms uniforms;
    assert_true(uniforms_read(gl, program, &uniforms));
    int found = uniforms_find(&uniforms, name);
    gl->UseProgram(program);
    if (found >= 0)
        uniform_set(gl, &uniforms.at[found], values);
    uniforms_free(&uniforms);
    return found >= 0;
}
#endif
