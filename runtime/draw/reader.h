/* Reads slots back from a G-buffer, as floats, by the GLSL that matc gives for that. */
#ifndef MATC_DRAW_READER_H
#define MATC_DRAW_READER_H
#include "runtime/draw/targets.h"
#include "runtime/gl/screen.h"

typedef struct {
    const char *unpack; /* MATC_UNPACK; only read while it is made */
    Target target;      /* that it was compiled for */
    const LayoutRow *layout;
    int width, height; /* of the G-buffer */
} ReaderSource;

typedef struct {
    Material program;
    Screen screen;
    Framebuffer values;     /* RGBA32F: a slot */
    bool holds[SLOT_COUNT]; /* the layout has it */
} Reader;

/* False: see the context's error; *made is empty. */
bool reader_make(Store *store, const ReaderSource *source, Reader *made);
/* Safe on an empty one, which it leaves behind. */
void reader_delete(Reader *reader);

/* Four floats a pixel, row 0 is the bottom row; lanes that the slot lacks are 0, and so is a slot
 * that the layout lacks. */
bool reader_read(Reader *reader, const Framebuffer *gbuffer, Slot slot, float *rgba);
#endif
