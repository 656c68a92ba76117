/* A G-buffer of any layout: points are drawn into it by matc's program, and read back by matc's
 * GLSL, slot by slot. */
#ifndef MATC_VALUE_GBUFFER_H
#define MATC_VALUE_GBUFFER_H
#include "tests/value/documents.h"
#include "draw.h"
#include "runtime/gpu_material/reader.h"

typedef struct {
    Drawer *drawer;       /* draws its points */
    MatcProgram *program; /* NULL for a layout that is not built in */
    const char *unpack;
    const LayoutRow *layout;
    Framebuffer targets;
    Shading shading;
    Material writer;
    Reader reader;
    char error[4096];
} Gbuffer;

/* Compiles a material of the document with the options. Returns false with a message in `error`.
 * Close it in any case. */
bool gbuffer_open(Gbuffer *g, Drawer *drawer, const Document *document, int material,
                  const MatcOptions *options);
/* Compiles the first material with any layout, for a document without uniforms; the layout of
 * the options is ignored. */
bool gbuffer_open_layout(Gbuffer *g, Drawer *drawer, Document *document, const LayoutRow *layout,
                         const MatcOptions *options);
void gbuffer_close(Gbuffer *g);
bool gbuffer_draw(Gbuffer *g, bool front);
/* Unpacks a slot of the layout: four floats per point. */
bool gbuffer_read(Gbuffer *g, Slot slot, float *rgba);
#endif
