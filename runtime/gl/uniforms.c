/* Queries a program's uniforms once; writes values to their storage. */
#include "runtime/gl/uniforms.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static int components_of(GLenum type)
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
    case GL_UNSIGNED_INT_VEC4:
        return 4;
    case GL_FLOAT_MAT3:
        return 9;
    case GL_FLOAT_MAT4:
        return 16;
    default:
        return 1; /* float, int, bool, uint and all samplers have one component */
    }
}

static bool has_blocks(const GlContext *gl)
{
    return gl->GetActiveUniformsiv && gl->GetActiveUniformBlockiv && gl->UniformBlockBinding &&
           gl->BindBufferBase;
}

static void read_member(const GlContext *gl, GLuint program, GLuint index, GlUniform *uniform)
{
    gl->GetActiveUniformsiv(program, 1, &index, GL_UNIFORM_BLOCK_INDEX, &uniform->block);
    gl->GetActiveUniformsiv(program, 1, &index, GL_UNIFORM_OFFSET, &uniform->offset);
    gl->GetActiveUniformsiv(program, 1, &index, GL_UNIFORM_MATRIX_STRIDE, &uniform->stride);
}

static bool read_uniform(const GlContext *gl, GLuint program, GLuint index, GLint longest,
                         GlUniform *uniform)
{
    GLint elements = 0;
    uniform->name = calloc((size_t)longest + 1, 1);
    if (!uniform->name)
        return false;
    gl->GetActiveUniform(program, index, longest + 1, NULL, &elements, &uniform->type,
                         uniform->name);
    uniform->components = components_of(uniform->type);
    uniform->location = gl->GetUniformLocation(program, uniform->name);
    uniform->block = -1;
    if (has_blocks(gl))
        read_member(gl, program, index, uniform);
    return true;
}

static bool read_all(GlContext *gl, GLuint program, GlUniforms *found)
{
    GLint count = 0, longest = 0;
    gl->GetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    gl->GetProgramiv(program, GL_ACTIVE_UNIFORM_MAX_LENGTH, &longest);
    found->at = calloc((size_t)count + 1, sizeof *found->at);
    for (GLint i = 0; found->at && i < count; i++, found->count++)
        if (!read_uniform(gl, program, (GLuint)i, longest, &found->at[i]))
            return false;
    return found->at != NULL;
}

static bool read_blocks(GlContext *gl, GLuint program, GlUniforms *found)
{
    GLint count = 0;
    if (has_blocks(gl))
        gl->GetProgramiv(program, GL_ACTIVE_UNIFORM_BLOCKS, &count);
    found->block_sizes = calloc((size_t)count + 1, sizeof *found->block_sizes);
    if (!found->block_sizes)
        return false;
    for (GLint i = 0; i < count; i++, found->block_count++) {
        gl->GetActiveUniformBlockiv(program, (GLuint)i, GL_UNIFORM_BLOCK_DATA_SIZE,
                                    &found->block_sizes[i]);
        gl->UniformBlockBinding(program, (GLuint)i, (GLuint)i);
    }
    const GLuint view = count && gl->GetUniformBlockIndex
                            ? gl->GetUniformBlockIndex(program, "View")
                            : GL_INVALID_INDEX;
    found->view = view == GL_INVALID_INDEX ? -1 : (int)view;
    if (found->view >= 0)
        gl->UniformBlockBinding(program, view, UNIFORMS_VIEW);
    return true;
}

bool uniforms_read(GlContext *gl, GLuint program, GlUniforms *found)
{
    memset(found, 0, sizeof *found);
    bool allocated = read_all(gl, program, found) && read_blocks(gl, program, found);
    if (allocated && gl_check(gl, "asking for a program's uniforms"))
        return true;
    uniforms_free(found);
    return allocated ? false : gl_fail(gl, "out of memory");
}

void uniforms_free(GlUniforms *uniforms)
{
    for (int i = 0; i < uniforms->count; i++)
        free(uniforms->at[i].name);
    free(uniforms->at);
    free(uniforms->block_sizes);
    memset(uniforms, 0, sizeof *uniforms);
}

int uniforms_find(const GlUniforms *uniforms, const char *name)
{
    for (int i = 0; i < uniforms->count; i++)
        if (!strcmp(uniforms->at[i].name, name))
            return i;
    return -1;
}

static void set_integers(const GlContext *gl, const GlUniform *plain, const float *values)
{
    GLint whole[4] = {0};
    for (int i = 0; i < plain->components && i < 4; i++)
        whole[i] = (GLint)values[i];
    switch (plain->components) {
    case 1:
        gl->Uniform1iv(plain->location, 1, whole);
        break;
    case 2:
        gl->Uniform2iv(plain->location, 1, whole);
        break;
    case 3:
        gl->Uniform3iv(plain->location, 1, whole);
        break;
    case 4:
        gl->Uniform4iv(plain->location, 1, whole);
        break;
    }
}

void uniform_set(const GlContext *gl, const GlUniform *plain, const float *values)
{
    switch (plain->type) {
    case GL_FLOAT:
        gl->Uniform1fv(plain->location, 1, values);
        break;
    case GL_FLOAT_VEC2:
        gl->Uniform2fv(plain->location, 1, values);
        break;
    case GL_FLOAT_VEC3:
        gl->Uniform3fv(plain->location, 1, values);
        break;
    case GL_FLOAT_VEC4:
        gl->Uniform4fv(plain->location, 1, values);
        break;
    case GL_FLOAT_MAT3:
        gl->UniformMatrix3fv(plain->location, 1, GL_FALSE, values);
        break;
    case GL_FLOAT_MAT4:
        gl->UniformMatrix4fv(plain->location, 1, GL_FALSE, values);
        break;
    case GL_UNSIGNED_INT:
        gl->Uniform1uiv(plain->location, 1, &(GLuint){(GLuint)values[0]});
        break;
    default:
        set_integers(gl, plain, values);
        break;
    }
}

static void write_component(GLenum type, float value, unsigned char *at)
{
    if (type == GL_UNSIGNED_INT)
        memcpy(at, &(uint32_t){(uint32_t)value}, 4);
    else if (type == GL_INT || type == GL_BOOL)
        memcpy(at, &(int32_t){(int32_t)value}, 4);
    else
        memcpy(at, &value, 4);
}

/* Columns of a mat3 are vectors of three, padded to four: offsets 0, 16, 32. */
void uniform_write(const GlUniform *member, const float *values, unsigned char *block)
{
    const int rows = member->components == 16  ? 4
                     : member->components == 9 ? 3
                                               : member->components;
    for (int i = 0; i < member->components; i++)
        write_component(member->type, values[i],
                        block + member->offset + i / rows * member->stride + i % rows * 4);
}
