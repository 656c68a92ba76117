/* Scenes of examples/scenes, prepared as tests draw them. */
#ifndef MATC_FRAME_EXAMPLE_H
#define MATC_FRAME_EXAMPLE_H
#include "runtime/scene/scene.h"

/* Reads examples/scenes/NAME.yaml, `width` pixels wide in its own proportions. A fault ends the
 * test. frame_forget() frees both. */
Scene *frame_example(const char *name, int width, const MatcOptions *options,
                     MatcDocument **document);
/* Its text, from malloc. */
char *frame_example_text(const char *name);

typedef struct {
    int width;
    const MatcOptions *options;
} FrameExample;
/* The scene of another text in the place of the example's. */
Scene *frame_example_of(const char *name, const char *text, const FrameExample *how,
                        MatcDocument **document);
#endif
