/* The uniforms of a linked program, plain ones and members of blocks alike: what each is called,
 * and where its value goes. */
#ifndef MATC_GL_UNIFORMS_H
#define MATC_GL_UNIFORMS_H
#include "runtime/gl/context.h"

typedef struct {
    char *name;
    GLenum type;
    int lanes;      /* 1-4; 9 and 16 for a matrix */
    GLint location; /* of a plain one; -1 for a member of a block */
    int block;      /* index of the block that it is a member of, or -1 */
    int offset;     /* of a member, in bytes */
    int stride;     /* from a column of a matrix to the next, in bytes */
} GlUniform;

typedef struct {
    GlUniform *at;
    int count;
    int *block_sizes; /* bytes of block i, which has the binding point i */
    int block_count;
    /* the block View, which is no program's own: it has the binding point UNIFORMS_VIEW. -1: there
     * is none */
    int view;
} GlUniforms;

enum { UNIFORMS_VIEW = 16 }; /* programs have fewer blocks */

/* Those that the driver did not drop, and the blocks' binding points are set. On false *found is
 * empty, see gl->error. */
bool uniforms_read(GlContext *gl, GLuint program, GlUniforms *found);
void uniforms_free(GlUniforms *uniforms);
/* Its index, or -1: a driver drops what a program does not use. */
int uniforms_find(const GlUniforms *uniforms, const char *name);

/* Numbers become what the type is: float, int, bool, uint, a matrix by columns, the texture unit of
 * a sampler. */
/* of the current program */
void uniform_set(const GlContext *gl, const GlUniform *plain, const float *values);
void uniform_write(const GlUniform *member, const float *values, unsigned char *block);
#endif
