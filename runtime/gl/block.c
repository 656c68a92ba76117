/* Uniform buffers. */
#include "runtime/gl/block.h"

GLuint block_make(const GlContext *gl, GLuint program, const char *name, GLuint binding, const void *bytes, size_t size)
{
    GLuint buffer = 0;
    if (!size || !gl->GetUniformBlockIndex || !gl->UniformBlockBinding || !gl->BindBufferBase)
        return 0;
    GLuint index = gl->GetUniformBlockIndex(program, name);
    if (index == GL_INVALID_INDEX)
        return 0;
    gl->GenBuffers(1, &buffer);
    gl->BindBuffer(GL_UNIFORM_BUFFER, buffer);
    gl->BufferData(GL_UNIFORM_BUFFER, (GLsizeiptr)size, bytes, GL_STATIC_DRAW);
    gl->UniformBlockBinding(program, index, binding);
    gl->BindBufferBase(GL_UNIFORM_BUFFER, binding, buffer);
    return buffer;
}
