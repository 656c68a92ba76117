/* Compiles and links GLSL texts to a program. */
#ifndef MATC_GL_PROGRAM_H
#define MATC_GL_PROGRAM_H
#include "runtime/gl/context.h"

enum { PROGRAM_PIECES = 64 }; /* max texts that form one shader */

/* Texts of a program. Locations that a text declares itself need no names here. */
typedef struct {
    const char *vertex[PROGRAM_PIECES]; /* texts that are concatenated; NULL ends the list */
    const char *fragment[PROGRAM_PIECES];
    /* Tessellation of patches with three corners; both or none. */
    const char *control[PROGRAM_PIECES], *evaluation[PROGRAM_PIECES];
    const char *geometry[PROGRAM_PIECES];
    /* Texts of a compute stage, which excludes all other stages. */
    const char *compute[PROGRAM_PIECES];
    /* Name i is bound to vertex attribute i; NULL: the names of mesh.h. */
    const char *const *attributes;
    int attribute_count;
    /* Name i is bound to color target i: `out` variables of GLSL 1.30 to 3.20; gl_FragData and
     * layout(location) need no names. */
    const char *const *outputs;
    int output_count;
    const char *const *
        /* `out` variables of the last stage before fragments, interleaved in the transform
         * feedback buffer. */
        captured;
    int captured_count;
} ProgramText;

/* Compiles and links. Returns 0 on failure; gl->error has the step ("vertex", "fragment",
 * "link") and the driver's log. */
GLuint program_make(GlContext *gl, const ProgramText *text);
#endif
