/* A context with render targets, in which scenes are drawn and G-buffers are read back by matc's
 * own GLSL. */
#ifndef MATC_VALUE_RIG_H
#define MATC_VALUE_RIG_H
#include "runtime/gpu_material/reader.h"
#include "runtime/gl/framebuffer.h"
#include "runtime/gl/mesh.h"
#include "scene.h"

enum { RIG_SIDE = 64, RIG_PIXELS = RIG_SIDE * RIG_SIDE, STAGE_TARGETS = 4 };
typedef struct {
    GlContext *gl;
    Store *store;
    Framebuffer full, half, depth; /* G-buffers in float and in half float; depth only */
    Screen screen;
    Mesh plane;
    float color[STAGE_TARGETS][RIG_PIXELS][4]; /* pixels of the last draw */
    float z[RIG_PIXELS];
    float slot[SLOT_COUNT][RIG_PIXELS][4]; /* slots unpacked from them */
    char error[4096];
} Rig;

extern const float rig_cleared, rig_cleared_depth; /* values of pixels without a fragment */

/* From malloc; check `error`. */
Rig *rig_new(bool core);
void rig_free(Rig *rig);
bool rig_begin(Rig *rig, const Framebuffer *target);
/* Reads the whole target back. */
bool rig_finish(Rig *rig, const Framebuffer *target);
/* Draws, from begin to finish; without a mesh, over the whole screen. */
bool rig_draw(Rig *rig, Scene *scene, const Space *space, const Mesh *mesh,
              const Framebuffer *target);
/* Reads a G-buffer with matc's unpacking program. */
bool rig_unpack(Rig *rig, const Scene *scene, const Framebuffer *source);
#endif
