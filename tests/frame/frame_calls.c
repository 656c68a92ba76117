/* Wrappers of GL functions, which count and then call the driver's function. */
#include "tests/frame/frame_calls.h"

FrameCalls frame_calls;

#define COUNTED(name, parameters, arguments, counts)                                               \
    static void(*original_##name) parameters;                                                      \
    static void count_##name parameters                                                            \
    {                                                                                              \
        counts;                                                                                    \
        original_##name arguments;                                                                 \
    }
COUNTED(GenBuffers, (GLsizei a, GLuint *b), (a, b), frame_calls.made++)
COUNTED(GenTextures, (GLsizei a, GLuint *b), (a, b), frame_calls.made++)
COUNTED(GenFramebuffers, (GLsizei a, GLuint *b), (a, b), frame_calls.made++)
COUNTED(GenVertexArrays, (GLsizei a, GLuint *b), (a, b), frame_calls.made++)
COUNTED(LinkProgram, (GLuint a), (a), (frame_calls.made++, frame_calls.programs++))
COUNTED(BufferData, (GLenum a, GLsizeiptr b, const void *c, GLenum d), (a, b, c, d),
        (frame_calls.written++, frame_calls.bytes += b))
COUNTED(BufferSubData, (GLenum a, GLintptr b, GLsizeiptr c, const void *d), (a, b, c, d),
        (frame_calls.written++, frame_calls.bytes += c))
COUNTED(TexStorage2D, (GLenum a, GLsizei b, GLenum c, GLsizei d, GLsizei e), (a, b, c, d, e),
        frame_calls.texels += (long)d * e)
COUNTED(TexImage2D,
        (GLenum a, GLint b, GLint c, GLsizei d, GLsizei e, GLint f, GLenum g, GLenum h,
         const void *i),
        (a, b, c, d, e, f, g, h, i), frame_calls.texels += (long)d * e)
COUNTED(UseProgram, (GLuint a), (a), frame_calls.programs++)
COUNTED(DrawElementsInstancedBaseInstance,
        (GLenum a, GLsizei b, GLenum c, const void *d, GLsizei e, GLuint f), (a, b, c, d, e, f),
        frame_calls.drawn++)

void frame_count_calls(GlContext *gl)
{
#define COUNT(name) original_##name = gl->name, gl->name = count_##name
    COUNT(GenBuffers);
    COUNT(GenTextures);
    COUNT(GenFramebuffers);
    COUNT(GenVertexArrays);
    COUNT(LinkProgram);
    COUNT(BufferData);
    COUNT(BufferSubData);
    COUNT(TexStorage2D);
    COUNT(TexImage2D);
    COUNT(UseProgram);
    COUNT(DrawElementsInstancedBaseInstance);
    frame_calls = (FrameCalls){0};
}
