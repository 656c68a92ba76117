/* Compiles, links, sets uniforms. */
#include "runtime/gl/program.h"
#include "runtime/gl/mesh.h"
#include <string.h>

/* Puts "<stage>: <log>" into gl->error. */
static void keep_log(GlContext *gl, const char *stage, const char *log)
{
    size_t length = strlen(log);
    while (length && strchr(" \n\r\t", log[length - 1]))
        length--; /* drivers end their logs by empty lines */
    if (length == 0)
        gl_fail(gl, "%s: the driver says no more", stage);
    else
        gl_fail(gl, "%s: %.*s", stage, (int)length, log);
}

static int count_pieces(const char *const *pieces)
{
    int count = 0;
    while (count < PROGRAM_PIECES && pieces[count])
        count++;
    return count;
}

static GLuint compile(GlContext *gl, GLenum stage, const char *const *pieces)
{
    const char *name = stage == GL_VERTEX_SHADER ? "vertex" : "fragment";
    int count = count_pieces(pieces);
    if (count == 0)
        return gl_fail(gl, "%s: no text", name), 0;
    GLuint shader = gl->CreateShader(stage);
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
    int attribute_count = text->attributes ? text->attribute_count : MESH_ATTRIBUTE_count;
    for (int i = 0; i < attribute_count; i++)
        gl->BindAttribLocation(program, (GLuint)i, attributes[i]);
    for (int i = 0; i < text->output_count; i++)
        gl->BindFragDataLocation(program, (GLuint)i, text->outputs[i]);
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

static GLuint join(GlContext *gl, GLuint vertex, GLuint fragment, const ProgramText *text)
{
    GLuint program = gl->CreateProgram();
    if (!program)
        return gl_fail(gl, "link: no program to be had"), 0;
    gl->AttachShader(program, vertex);
    gl->AttachShader(program, fragment);
    bind_names(gl, program, text);
    if (link(gl, program))
        return program;
    gl->DeleteProgram(program);
    return 0;
}

GLuint program_make(GlContext *gl, const ProgramText *text)
{
    GLuint vertex = compile(gl, GL_VERTEX_SHADER, text->vertex);
    if (!vertex)
        return 0;
    GLuint fragment = compile(gl, GL_FRAGMENT_SHADER, text->fragment);
    GLuint program = fragment ? join(gl, vertex, fragment, text) : 0;
    gl->DeleteShader(vertex); /* the program keeps what it needs */
    gl->DeleteShader(fragment);
    if (program && !gl_check(gl, "making a program")) {
        gl->DeleteProgram(program);
        return 0;
    }
    return program;
}

/* The type of an active uniform, 0 when there is none of that name. */
static GLenum find_type(const GlContext *gl, GLuint program, const char *name)
{
    GLint count = 0;
    gl->GetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; i++) {
        char found[256] = "";
        GLint elements = 0;
        GLenum type = 0;
        gl->GetActiveUniform(program, (GLuint)i, sizeof found, NULL, &elements, &type, found);
        if (strcmp(found, name) == 0)
            return type;
    }
    return 0;
}

static int lanes_of(GLenum type)
{
    switch (type) {
    case GL_FLOAT_VEC2:
    case GL_INT_VEC2:
    case GL_BOOL_VEC2:
        return 2;
    case GL_FLOAT_VEC3:
    case GL_INT_VEC3:
    case GL_BOOL_VEC3:
        return 3;
    case GL_FLOAT_VEC4:
    case GL_INT_VEC4:
    case GL_BOOL_VEC4:
        return 4;
    case GL_FLOAT_MAT3:
        return 9;
    case GL_FLOAT_MAT4:
        return 16;
    default:
        return 1; /* float, int, bool, uint and every sampler */
    }
}

static void set_integers(const GlContext *gl, GLint location, const ProgramValue *value)
{
    GLint whole[4] = {0};
    for (int i = 0; i < value->lanes; i++)
        whole[i] = (GLint)value->values[i];
    switch (value->lanes) {
    case 1:
        gl->Uniform1iv(location, 1, whole);
        break;
    case 2:
        gl->Uniform2iv(location, 1, whole);
        break;
    case 3:
        gl->Uniform3iv(location, 1, whole);
        break;
    case 4:
        gl->Uniform4iv(location, 1, whole);
        break;
    }
}

static void set(const GlContext *gl, GLint location, GLenum type, const ProgramValue *value)
{
    switch (type) {
    case GL_FLOAT:
        gl->Uniform1fv(location, 1, value->values);
        break;
    case GL_FLOAT_VEC2:
        gl->Uniform2fv(location, 1, value->values);
        break;
    case GL_FLOAT_VEC3:
        gl->Uniform3fv(location, 1, value->values);
        break;
    case GL_FLOAT_VEC4:
        gl->Uniform4fv(location, 1, value->values);
        break;
    case GL_FLOAT_MAT3:
        gl->UniformMatrix3fv(location, 1, GL_FALSE, value->values);
        break;
    case GL_FLOAT_MAT4:
        gl->UniformMatrix4fv(location, 1, GL_FALSE, value->values);
        break;
    case GL_UNSIGNED_INT:
        gl->Uniform1uiv(location, 1, &(GLuint){(GLuint)value->values[0]});
        break;
    default:
        set_integers(gl, location, value);
        break;
    }
}

bool program_set(GlContext *gl, GLuint program, const ProgramValue *value)
{
    gl->UseProgram(program);
    GLint location = gl->GetUniformLocation(program, value->name);
    if (location < 0)
        return false; /* not used */
    GLenum type = find_type(gl, program, value->name);
    if (type == 0 || lanes_of(type) != value->lanes)
        return false;
    set(gl, location, type, value);
    return gl_check(gl, value->name);
}
