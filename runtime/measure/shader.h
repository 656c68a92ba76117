/* A material as a GL program that fields are drawn with, with its textures and its uniforms' defaults. */
#ifndef MATC_MEASURE_SHADER_H
#define MATC_MEASURE_SHADER_H
#include "compiler/matc.h"
#include "runtime/gl/context.h"

enum { SHADER_TEXTURES = 16 };

typedef struct {
    GLuint name;
    MatcProgram *program; /* NULL: of plain text */
    GLuint textures[SHADER_TEXTURES];
    int texture_count;
    GLuint constants; /* buffer of its block of numbers, or 0 */
} Shader;

/* Compiles a material for GLSL 3.30, without glslang. NULL: it does not compile. Free with matc_program_free. */
MatcProgram *shader_compile(const MatcDocument *document, int material, unsigned outputs, const MatcOptions *options);
/* Takes the program over. False: see gl->error; delete in any case. */
bool shader_make(GlContext *gl, MatcProgram *program, Shader *made);
/* A fragment program as plain text, one that reads a G-buffer for example. */
bool shader_make_plain(GlContext *gl, const char *const *fragment, int pieces, Shader *made);
/* Makes it the current program, with its textures bound and the picture moved by a jitter in clip space. */
void shader_use(GlContext *gl, const Shader *shader, const float jitter[2]);
void shader_delete(const GlContext *gl, Shader *shader);
#endif
