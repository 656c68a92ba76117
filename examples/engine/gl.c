/* A context, its functions, programs and textures. */
#include "gl.h"
#include <GL/osmesa.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

Gl gl;

void fail(const char *what, const char *why)
{
    fprintf(stderr, "engine: %s: %s\n", what, why);
    exit(1);
}

void gl_open(void)
{
    static unsigned char window[4]; /* OSMesa wants one; frames are drawn to textures */
    static const int wanted[] = {OSMESA_PROFILE,
                                 OSMESA_CORE_PROFILE,
                                 OSMESA_CONTEXT_MAJOR_VERSION,
                                 3,
                                 OSMESA_CONTEXT_MINOR_VERSION,
                                 3,
                                 0};
    OSMesaContext context = OSMesaCreateContextAttribs(wanted, NULL);
    if (!context || !OSMesaMakeCurrent(context, window, GL_UNSIGNED_BYTE, 1, 1))
        fail("OSMesa", "no core context of OpenGL 3.3");
#define F(NAME, Name)                                                                              \
    gl.Name = (PFNGL##NAME##PROC)(void (*)(void))OSMesaGetProcAddress("gl" #Name);                 \
    if (!gl.Name)                                                                                  \
        fail("gl" #Name, "not in this OpenGL");
    GL_FUNCTIONS(F)
#undef F
}

GLuint gl_program(const char *name, const char *vertex, const char *fragment)
{
    const struct {
        GLenum stage;
        const char *text;
    } parts[] = {{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}};
    GLuint program = gl.CreateProgram();
    for (int i = 0; i < 2; i++) {
        GLuint shader = gl.CreateShader(parts[i].stage);
        gl.ShaderSource(shader, 1, &parts[i].text, NULL);
        gl.CompileShader(shader);
        gl.AttachShader(program, shader);
    }
    gl.LinkProgram(program);
    GLint linked = 0;
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked) {
        char log[2048] = "";
        gl.GetProgramInfoLog(program, sizeof log, NULL, log);
        fail(name, log);
    }
    return program;
}

GLuint gl_texture(GLenum internal, GLenum format, GLenum type, int width, int height,
                  const void *pixels)
{
    GLuint name;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, (GLint)internal, width, height, 0, format, type, pixels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return name;
}

static GLint wrap_of(const char *name)
{
    static const struct {
        const char *name;
        GLint wrap;
    } rows[] = {{"mirrored_repeat", GL_MIRRORED_REPEAT},
                {"clamp_to_edge", GL_CLAMP_TO_EDGE},
                {"clamp_to_border", GL_CLAMP_TO_BORDER}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (!strcmp(rows[i].name, name))
            return rows[i].wrap;
    return GL_REPEAT;
}

GLuint gl_sampler(bool mipmaps, int anisotropy, const char *wrap)
{
    GLuint name;
    GLfloat most = 1; /* stays where the driver knows of none */
    glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &most);
    glGetError();
    gl.GenSamplers(1, &name);
    gl.SamplerParameteri(name, GL_TEXTURE_MIN_FILTER,
                         mipmaps ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST);
    gl.SamplerParameteri(name, GL_TEXTURE_MAG_FILTER, mipmaps ? GL_LINEAR : GL_NEAREST);
    gl.SamplerParameteri(name, GL_TEXTURE_WRAP_S, wrap_of(wrap));
    gl.SamplerParameteri(name, GL_TEXTURE_WRAP_T, wrap_of(wrap));
    if (anisotropy > 1 && most > 1)
        gl.SamplerParameteri(name, GL_TEXTURE_MAX_ANISOTROPY_EXT,
                             anisotropy < (int)most ? anisotropy : (int)most);
    return name;
}
