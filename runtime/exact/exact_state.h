/* State of exact shadows for a scene. */
#ifndef MATC_EXACT_EXACT_STATE_H
#define MATC_EXACT_EXACT_STATE_H
#include "runtime/exact/exact_cover.h"
#include "runtime/frame/frame.h"

struct ExactShadows {
    ExactTriangles triangles;
    ExactCover cover;       /* lists; its programs live as long as the renderer */
    bool seen;              /* the target `seen` is valid for this frame's camera */
    GLuint corners, firsts; /* buffers: triangles; each object's first, counted from 1 */
};
#endif
