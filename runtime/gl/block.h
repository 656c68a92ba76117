/* A uniform block's buffer. */
#ifndef MATC_GL_BLOCK_H
#define MATC_GL_BLOCK_H
#include "runtime/gl/context.h"

/* Makes a buffer of the bytes, gives the program's block that binding point, and binds the buffer there. 0 where the program
 * has no such block, as a driver drops one that nothing reads, and where the driver knows no blocks. */
GLuint block_make(const GlContext *gl, GLuint program, const char *name, GLuint binding, const void *bytes,
                  size_t size);
#endif
