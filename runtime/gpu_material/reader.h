/* Reads slots back from a G-buffer as floats, by matc's unpacking GLSL. */
#ifndef MATC_GPU_MATERIAL_READER_H
#define MATC_GPU_MATERIAL_READER_H
#include "runtime/gpu_material/targets.h"
#include "runtime/gl/screen.h"

typedef struct {
    const char *unpack; /* text of MATC_UNPACK; needed only during reader_make() */
    Target target;      /* GLSL version of `unpack` */
    const LayoutRow *layout;
    int width, height; /* size of the G-buffer */
} ReaderSource;

typedef struct {
    Material program;
    Screen screen;
    Framebuffer values;     /* RGBA32F target of the selected slot */
    bool holds[SLOT_COUNT]; /* the layout stores the slot */
} Reader;

/* Makes a reader. Returns false on failure, with *made empty; see the context's error. */
bool reader_make(Store *store, const ReaderSource *source, Reader *made);
/* Frees the reader and leaves it empty; safe on an empty one. */
void reader_delete(Reader *reader);

/* Reads a slot, four floats per pixel, row 0 at the bottom. Components that the slot lacks are
 * 0, and so is a slot that the layout lacks. */
bool reader_read(Reader *reader, const Framebuffer *gbuffer, Slot slot, float *rgba);
#endif
