/* Scenes of examples/scenes, prepared as tests draw them. */
#ifndef MATC_FRAME_EXAMPLE_H
#define MATC_FRAME_EXAMPLE_H
#include "runtime/scene/scene.h"

/* Reads examples/scenes/NAME.yaml with the width `width` and the original aspect ratio. An error
 * ends the test. frame_forget() frees both results. */
Scene *frame_example(const char *name, int width, const MatcOptions *options,
                     MatcDocument **document);
/* The example's text, from malloc. */
char *frame_example_text(const char *name);

typedef struct {
    int width;
    const MatcOptions *options;
} FrameExample;
/* Reads a scene from another text as if that were the example's. */
Scene *frame_example_of(const char *name, const char *text, const FrameExample *how,
                        MatcDocument **document);
#endif
