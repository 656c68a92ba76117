/* Scenes of examples/scenes as tests draw them. */
#ifndef MATC_FRAME_EXAMPLE_H
#define MATC_FRAME_EXAMPLE_H
#include "runtime/scene/scene.h"

/* Reads examples/scenes/NAME.yaml, `width` pixels wide in its own proportions. A fault ends the
 * test. frame_forget() frees both. */
Scene *frame_example(const char *name, int width, const MatcOptions *options, MatcDocument **document);
#endif
