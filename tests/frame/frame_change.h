/* Further frames of a renderer that has already drawn: after a change the picture must equal
 * that of a new renderer. A failure ends the test. */
#ifndef MATC_FRAME_CHANGE_H
#define MATC_FRAME_CHANGE_H
#include "tests/frame/frame_draw.h"

/* One more frame: four floats a pixel, from malloc. */
float *frame_change_next(Renderer *renderer);
/* The next frame is the one that a new renderer draws, bit for bit. */
void frame_change_assert(GlContext *gl, const RendererOptions *how, Renderer *changed,
                         const Scene *scene);

/* Motions, one after the other, in the world's units: object 1 along x, a light along an axis; then
 * the camera, a quarter up. */
typedef struct {
    double object;
    int light, axis;
    double by;
} FrameMoves;

/* Draws a scene; a second frame makes and writes nothing; after each move the picture is that of a
 * new renderer. Of a context whose calls may be counted from now on (frame_calls.h). */
void frame_change_moves(GlContext *gl, const RendererOptions *how, Scene *scene,
                        const FrameMoves *moves);
#endif
