/* What exact shadows keep of a scene. */
#ifndef MATC_EXACT_EXACT_STATE_H
#define MATC_EXACT_EXACT_STATE_H
#include "runtime/exact/exact_cover.h"
#include "runtime/frame/frame.h"

struct ExactShadows {
    ExactTriangles triangles;
    ExactCover cover;       /* lists; its programs stay until the renderer goes */
    bool seen;              /* the target of that name has what the camera sees */
    GLuint corners, firsts; /* buffers: of triangles; of numbers of objects' first ones, counted from 1 */
};
#endif
