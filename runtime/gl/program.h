/* GLSL texts in, a linked program out. */
#ifndef MATC_GL_PROGRAM_H
#define MATC_GL_PROGRAM_H
#include "runtime/gl/context.h"

enum { PROGRAM_PIECES = 64 }; /* texts that one shader may be put together from */

/* Texts of a program. Locations that a text itself declares need no names here. */
typedef struct {
    const char *vertex[PROGRAM_PIECES]; /* read one after the other; NULL ends the list */
    const char *fragment[PROGRAM_PIECES];
    /* both or none: of patches of three corners */
    const char *control[PROGRAM_PIECES], *evaluation[PROGRAM_PIECES];
    const char *geometry[PROGRAM_PIECES];
    /* alone, where the others have none */
    const char *compute[PROGRAM_PIECES];
    /* name i is bound to vertex attribute i; NULL: those of mesh.h */
    const char *const *attributes;
    int attribute_count;
    /* name i is bound to colour target i: `out` variables of GLSL 1.30 to 3.20; gl_FragData and
     * layout(location) need none */
    const char *const *outputs;
    int output_count;
    const char *const *
        /* `out` variables of the last stage before fragments, one behind the other in the buffer of
         * transform feedback */
        captured;
    int captured_count;
} ProgramText;

/* Compiles and links. 0: gl->error has the step ("vertex", "fragment", "link") and the driver's
 * log. */
GLuint program_make(GlContext *gl, const ProgramText *text);
#endif
