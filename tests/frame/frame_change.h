/* Further frames of a renderer that has already drawn: after a change the picture must equal
 * that of a new renderer. A failure ends the test. */
#ifndef MATC_FRAME_CHANGE_H
#define MATC_FRAME_CHANGE_H
#include "tests/frame/frame_draw.h"

/* Draws one more frame: four floats per pixel, from malloc. */
float *frame_change_next(Renderer *renderer);
/* Checks that the next frame equals that of a new renderer, bit for bit. */
void frame_change_assert(GlContext *gl, const RendererOptions *how, Renderer *changed,
                         const Scene *scene);

/* Consecutive motions in world units: object 1 along x, a light along an axis; then the camera,
 * a quarter of that up. */
typedef struct {
    double object;
    int light, axis;
    double by;
} FrameMoves;

/* Draws a scene; checks that a second frame creates and writes nothing, and that after each
 * motion the picture equals that of a new renderer. Counts the context's calls from now on
 * (frame_calls.h). */
void frame_change_moves(GlContext *gl, const RendererOptions *how, Scene *scene,
                        const FrameMoves *moves);
#endif
