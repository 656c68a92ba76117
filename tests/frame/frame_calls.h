/* Counts the GL calls of a context, for tests. */
#ifndef MATC_FRAME_CALLS_H
#define MATC_FRAME_CALLS_H
#include "runtime/gl/context.h"

typedef struct {
    int made;     /* buffers, textures, framebuffers, vertex arrays, linked programs */
    int written;  /* buffers */
    int drawn;    /* by instances */
    int programs; /* linked, and made current */
    long bytes;   /* written to buffers */
    long texels;  /* of flat textures that were made, of all levels given */
} FrameCalls;

extern FrameCalls frame_calls;
/* From 0, for this context, until another is asked for. */
void frame_count_calls(GlContext *gl);
#endif
