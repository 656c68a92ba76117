/* Uniforms of a linked program, plain ones and members of blocks: their names, types and
 * storage. */
#ifndef MATC_GL_UNIFORMS_H
#define MATC_GL_UNIFORMS_H
#include "runtime/gl/context.h"

typedef struct {
    char *name;
    GLenum type;
    int components; /* number of components: 1 to 4; 9 and 16 for a matrix */
    GLint location; /* location of a plain uniform; -1 for a member of a block */
    int block;      /* index of the member's block; -1: none */
    int offset;     /* offset of a member in its block, in bytes */
    int stride;     /* stride between columns of a matrix, in bytes */
} GlUniform;

typedef struct {
    GlUniform *at;
    int count;
    int *block_sizes; /* size of block i in bytes; its binding point is i */
    int block_count;
    /* Index of the block View, which programs share: its binding point is UNIFORMS_VIEW. -1:
     * none. */
    int view;
} GlUniforms;

/* binding point of the block View; programs have fewer blocks of their own */
enum { UNIFORMS_VIEW = 16 };

/* Reads the active uniforms, and assigns binding points to blocks. Returns false on failure,
 * with *found empty; see gl->error. */
bool uniforms_read(GlContext *gl, GLuint program, GlUniforms *found);
void uniforms_free(GlUniforms *uniforms);
/* Returns the index of a uniform; -1 if the program has none with the given name, or the driver
 * removed it as unused. */
int uniforms_find(const GlUniforms *uniforms, const char *name);

/* Set a plain uniform of the current program, or write a member into its block. Floats are
 * converted to the uniform's type: float, int, bool, uint, a matrix by columns, or the texture
 * unit of a sampler. */
void uniform_set(const GlContext *gl, const GlUniform *plain, const float *values);
void uniform_write(const GlUniform *member, const float *values, unsigned char *block);
#endif
