/* Counts the GL calls of a context, for tests. */
#ifndef MATC_FRAME_CALLS_H
#define MATC_FRAME_CALLS_H
#include "runtime/gl/context.h"

typedef struct {
    int made;     /* created buffers, textures, framebuffers, vertex arrays, programs */
    int written;  /* buffer writes */
    int drawn;    /* instanced draw calls */
    int programs; /* programs linked, and made current */
    long bytes;   /* bytes written to buffers */
    long texels;  /* texels of created 2D textures, all given levels */
} FrameCalls;

extern FrameCalls frame_calls;
/* Starts counting from 0 for this context, until called for another. */
void frame_count_calls(GlContext *gl);
#endif
