/* A scene and the renderer that draws it frame after frame, for tests of what changes between
 * frames. */
#ifndef MATC_FRAME_RUNNING_H
#define MATC_FRAME_RUNNING_H
#include "runtime/renderer/renderer.h"

typedef struct {
    MatcOptions options; /* from frame_exact_options */
    MatcDocument *document;
    Scene *scene; /* camera, lights and objects may be changed in place */
    Renderer *renderer;
    float *rgba; /* the last frame */
} FrameRunning;

/* Opens a document without drawing; uses `options` except `compile`. A failure ends the test. */
void frame_running_open(GlContext *gl, const char *text, const RendererOptions *options,
                        FrameRunning *made);
/* Draws a frame; the result is valid until the next one. */
const float *frame_running_draw(FrameRunning *running);
void frame_running_close(FrameRunning *running);
#endif
