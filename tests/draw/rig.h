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
    Framebuffer full, half, depth; /* G-buffers in float and in half float; depth alone */
    Screen screen;
    Mesh plane;
    float color[STAGE_TARGETS][RIG_PIXELS][4]; /* what was drawn last */
    float z[RIG_PIXELS];
    float slot[SLOT_COUNT][RIG_PIXELS][4]; /* what was read back of it */
    char error[4096];
} Rig;

extern const float rig_cleared, rig_cleared_depth; /* where nothing was drawn */

/* From malloc; look into error. */
Rig *rig_new(bool core);
void rig_free(Rig *rig);
bool rig_begin(Rig *rig, const Framebuffer *target);
/* Reads all of the target. */
bool rig_finish(Rig *rig, const Framebuffer *target);
/* From begin to finish; without a mesh, the whole screen is drawn. */
bool rig_draw(Rig *rig, Scene *scene, const Space *space, const Mesh *mesh,
              const Framebuffer *target);
/* Reads a G-buffer by the program that matc gives for that. */
bool rig_unpack(Rig *rig, const Scene *scene, const Framebuffer *source);
#endif
