/* A context with targets, in which scenes are drawn and G-buffers are read back by matc's own GLSL. */
#ifndef MATC_VALUE_STAGE_H
#define MATC_VALUE_STAGE_H
#include "runtime/gl/framebuffer.h"
#include "runtime/gl/mesh.h"
#include "runtime/render/reader.h"
#include "scene.h"

enum { STAGE_SIDE = 64, STAGE_PIXELS = STAGE_SIDE * STAGE_SIDE, STAGE_TARGETS = 4 };
typedef struct {
    GlContext *gl;
    Store *store;
    Framebuffer full, half, depth; /* G-buffers in float and in half float; depth alone */
    Screen screen;
    Mesh plane;
    float color[STAGE_TARGETS][STAGE_PIXELS][4]; /* what was drawn last */
    float z[STAGE_PIXELS];
    float slot[SLOT_COUNT][STAGE_PIXELS][4]; /* what was read back of it */
    char error[4096];
} Stage;

extern const float stage_cleared, stage_cleared_depth; /* where nothing was drawn */

/* From malloc; look into error. */
Stage *stage_new(bool core);
void stage_free(Stage *stage);
bool stage_begin(Stage *stage, const Framebuffer *target);
/* Reads all of the target. */
bool stage_finish(Stage *stage, const Framebuffer *target);
/* From begin to finish; without a mesh, the whole screen is drawn. */
bool stage_draw(Stage *stage, Scene *scene, const Space *space, const Mesh *mesh, const Framebuffer *target);
/* Reads a G-buffer by the program that matc gives for that. */
bool stage_unpack(Stage *stage, const Scene *scene, const Framebuffer *source);
#endif
