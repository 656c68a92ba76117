/* A context with targets, in which scenes are drawn and G-buffers are read back by matc's own GLSL. */
#ifndef MATC_VALUE_STAGE_H
#define MATC_VALUE_STAGE_H
#include "runtime/gl/framebuffer.h"
#include "runtime/gl/mesh.h"
#include "scene.h"

enum { STAGE_SIDE = 64, STAGE_PIXELS = STAGE_SIDE * STAGE_SIDE, STAGE_TARGETS = 4 };
/* What is read back: normal and shininess; diffuse and transparencyShininess; the others alone. */
enum {
    READ_normal,
    READ_diffuse,
    READ_specular,
    READ_transparency,
    READ_emissive,
    READ_diffuseTransparency,
    READ_COUNT
};

typedef struct {
    GlContext *gl;
    Framebuffer full, half, depth, unpacked; /* G-buffers in float and in half float; depth alone; what is read back */
    Mesh none, plane;
    float color[STAGE_TARGETS][STAGE_PIXELS][4]; /* what was drawn last */
    float z[STAGE_PIXELS];
    float slot[READ_COUNT][STAGE_PIXELS][4]; /* what was read back of it */
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
bool stage_draw(Stage *stage, const Scene *scene, const Space *space, const Mesh *mesh, const Framebuffer *target);
/* Reads a G-buffer by the program that matc gives for that. */
bool stage_unpack(Stage *stage, const Scene *scene, const Framebuffer *source);
#endif
