/* A view of the depth buffer as a mesh, seen from the side. */
#ifndef MATC_INDIRECT_PASS_POSITIONS_H
#define MATC_INDIRECT_PASS_POSITIONS_H
#include "runtime/frame_graph/frame_pass.h"

struct FramePositions {
    Material material;
    GLuint array; /* array without buffers: vertices are computed from gl_VertexID */
};

bool pass_positions_is_view(const char *view);
/* The row of the frame graph. */
extern const FramePass pass_positions;
#endif
