/* Compiles and links programs. */
#include "runtime/gl/program.h"
#include "runtime/gl/mesh.h"
#include <string.h>

/* Stores "<step>: <log>" in gl->error. */
static void keep_log(GlContext *gl, const char *step, const char *log)
{
    size_t length = strlen(log);
    while (length && strchr(" \n\r\t", log[length - 1]))
        length--; /* drivers end their logs with empty lines */
    if (length == 0)
        gl_fail(gl, "%s: the driver says no more", step);
    else
        gl_fail(gl, "%s: %.*s", step, (int)length, log);
}

static int count_pieces(const char *const *pieces)
{
    int count = 0;
    while (count < PROGRAM_PIECES && pieces[count])
        count++;
    return count;
}

static GLuint compile(GlContext *gl, GLenum type, const char *const *pieces)
{
    const char *name = type == GL_VERTEX_SHADER            ? "vertex"
                       : type == GL_COMPUTE_SHADER         ? "compute"
                       : type == GL_TESS_CONTROL_SHADER    ? "tessellation control"
                       : type == GL_GEOMETRY_SHADER        ? "geometry"
                       : type == GL_TESS_EVALUATION_SHADER ? "tessellation evaluation"
                                                           : "fragment";
    int count = count_pieces(pieces);
    if (count == 0)
        return gl_fail(gl, "%s: no text", name), 0;
    GLuint shader = gl->CreateShader(type);
    if (!shader)
        return gl_fail(gl, "%s: no shader to be had", name), 0;
    gl->ShaderSource(shader, count, pieces, NULL);
    gl->CompileShader(shader);
    GLint compiled = GL_FALSE;
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled)
        return shader;
    char log[3072] = "";
    gl->GetShaderInfoLog(shader, sizeof log, NULL, log);
    keep_log(gl, name, log);
    gl->DeleteShader(shader);
    return 0;
}

static void bind_names(const GlContext *gl, GLuint program, const ProgramText *text)
{
    const char *const *attributes = text->attributes ? text->attributes : mesh_attribute_names;
    int attribute_count = text->attributes ? text->attribute_count : MESH_ATTRIBUTE_end;
    for (int i = 0; i < attribute_count; i++)
        if (attributes[i])
            gl->BindAttribLocation(program, (GLuint)i, attributes[i]);
    for (int i = 0; i < text->output_count; i++)
        gl->BindFragDataLocation(program, (GLuint)i, text->outputs[i]);
    if (text->captured_count)
        gl->TransformFeedbackVaryings(program, text->captured_count, text->captured,
                                      GL_INTERLEAVED_ATTRIBS);
}

static bool link(GlContext *gl, GLuint program)
{
    gl->LinkProgram(program);
    GLint linked = GL_FALSE;
    gl->GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked)
        return true;
    char log[3072] = "";
    gl->GetProgramInfoLog(program, sizeof log, NULL, log);
    keep_log(gl, "link", log);
    return false;
}

typedef struct {
    GLuint at[5]; /* shader objects; 0: unused */
    int count;
} Shaders;

static GLuint join(GlContext *gl, const Shaders *shaders, const ProgramText *text)
{
    GLuint program = gl->CreateProgram();
    if (!program)
        return gl_fail(gl, "link: no program to be had"), 0;
    for (int i = 0; i < shaders->count; i++)
        gl->AttachShader(program, shaders->at[i]);
    bind_names(gl, program, text);
    if (link(gl, program))
        return program;
    gl->DeleteProgram(program);
    return 0;
}

/* Compiles and adds a shader; returns false on failure. */
static bool add(GlContext *gl, GLenum type, const char *const *pieces, Shaders *shaders)
{
    const GLuint shader = compile(gl, type, pieces);
    if (shader)
        shaders->at[shaders->count++] = shader;
    return shader != 0;
}

GLuint program_make(GlContext *gl, const ProgramText *text)
{
    Shaders shaders = {{0}, 0};
    bool fine;
    if (text->compute[0]) /* a compute stage excludes all other stages */
        fine = add(gl, GL_COMPUTE_SHADER, text->compute, &shaders);
    else
        fine = add(gl, GL_VERTEX_SHADER, text->vertex, &shaders) &&
               (!text->control[0] ||
                (add(gl, GL_TESS_CONTROL_SHADER, text->control, &shaders) &&
                 add(gl, GL_TESS_EVALUATION_SHADER, text->evaluation, &shaders))) &&
               (!text->geometry[0] || add(gl, GL_GEOMETRY_SHADER, text->geometry, &shaders)) &&
               add(gl, GL_FRAGMENT_SHADER, text->fragment, &shaders);
    GLuint program = fine ? join(gl, &shaders, text) : 0;
    for (int i = 0; i < shaders.count; i++)
        gl->DeleteShader(shaders.at[i]); /* the program keeps its shaders alive */
    if (program && !gl_check(gl, "making a program")) {
        gl->DeleteProgram(program);
        return 0;
    }
    return program;
}
