/* OpenGL 3.3 without a window, by OSMesa. Every function is asked for by name, as an engine's
 * loader does. */
#ifndef ENGINE_GL_H
#define ENGINE_GL_H
#include <GL/gl.h>
#include <GL/glext.h>
#include <stdbool.h>

// clang-format off
#define GL_FUNCTIONS(F) \
    F(ACTIVETEXTURE, ActiveTexture) F(ATTACHSHADER, AttachShader) F(BINDBUFFER, BindBuffer) \
    F(BINDBUFFERRANGE, BindBufferRange) F(BINDFRAMEBUFFER, BindFramebuffer) \
    F(BINDSAMPLER, BindSampler) F(BINDVERTEXARRAY, BindVertexArray) F(BUFFERDATA, BufferData) \
    F(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus) F(COMPILESHADER, CompileShader) \
    F(CREATEPROGRAM, CreateProgram) F(CREATESHADER, CreateShader) F(DRAWBUFFERS, DrawBuffers) \
    F(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray) \
    F(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D) F(GENBUFFERS, GenBuffers) \
    F(GENERATEMIPMAP, GenerateMipmap) F(GENFRAMEBUFFERS, GenFramebuffers) \
    F(GENSAMPLERS, GenSamplers) F(GENVERTEXARRAYS, GenVertexArrays) \
    F(GETPROGRAMINFOLOG, GetProgramInfoLog) F(GETPROGRAMIV, GetProgramiv) \
    F(GETUNIFORMBLOCKINDEX, GetUniformBlockIndex) F(GETUNIFORMLOCATION, GetUniformLocation) \
    F(LINKPROGRAM, LinkProgram) F(SAMPLERPARAMETERI, SamplerParameteri) \
    F(SHADERSOURCE, ShaderSource) F(UNIFORM1FV, Uniform1fv) F(UNIFORM1I, Uniform1i) \
    F(UNIFORM2FV, Uniform2fv) F(UNIFORM3FV, Uniform3fv) F(UNIFORM4FV, Uniform4fv) \
    F(UNIFORMBLOCKBINDING, UniformBlockBinding) F(UNIFORMMATRIX3FV, UniformMatrix3fv) \
    F(UNIFORMMATRIX4FV, UniformMatrix4fv) F(USEPROGRAM, UseProgram) \
    F(VERTEXATTRIBPOINTER, VertexAttribPointer)
// clang-format on

/* gl.UseProgram and so on; those of OpenGL 1.1 are linked. */
typedef struct {
#define F(NAME, Name) PFNGL##NAME##PROC Name;
    GL_FUNCTIONS(F)
#undef F
} Gl;
extern Gl gl;

/* The engine gives up by this: "engine: what: why". */
_Noreturn void fail(const char *what, const char *why);
void gl_open(void);
/* A linked program from two texts. `name` is for messages. */
GLuint gl_program(const char *name, const char *vertex, const char *fragment);
/* Nearest texels, repeated; `pixels` may be NULL. */
GLuint gl_texture(GLenum internal, GLenum format, GLenum type, int width, int height,
                  const void *pixels);
/* Sampler with the settings of a program's reflection, as far as the driver has them; a border is
 * 0 in all components, OpenGL's default. */
GLuint gl_sampler(bool mipmaps, int anisotropy, const char *wrap);
#endif
