/* A scene and the renderer that draws it frame after frame, for tests of what changes between
 * frames. */
#ifndef MATC_FRAME_RUNNING_H
#define MATC_FRAME_RUNNING_H
#include "runtime/renderer/renderer.h"

typedef struct {
    MatcOptions options; /* frame_exact_options */
    MatcDocument *document;
    Scene *scene; /* its camera, lights and objects may be changed where they stand */
    Renderer *renderer;
    float *rgba; /* the frame that was drawn last */
} FrameRunning;

/* Opens a document, without a frame yet; `options` except `compile`. A failure ends the test. */
void frame_running_open(GlContext *gl, const char *text, const RendererOptions *options,
                        FrameRunning *made);
/* Draws a frame: its view, which is there until the next. */
const float *frame_running_draw(FrameRunning *running);
void frame_running_close(FrameRunning *running);
#endif
