/* Draws scenes for tests: a failure ends the test and prints its reason. */
#ifndef MATC_FRAME_DRAW_H
#define MATC_FRAME_DRAW_H
#include "runtime/renderer/renderer.h"
#include "runtime/scene_reader/scene_read.h"

/* The layout `integer`, exact powers, no filtering: references evaluate points. */
MatcOptions frame_exact_options(void);
/* A layout of unquantized floats, so that errors are those of the passes. Release the layout
 * after everything that was drawn with it. */
MatcOptions frame_float_options(MatcLayout **layout);
Scene *frame_scene(const char *text, const MatcOptions *options, MatcDocument **document);
GlContext *frame_context(void);
GlContext *frame_context_of(GlKind kind);
/* The kind of context named by a test's last argument, as in `build/tests/test_x egl`; else
 * OSMesa. */
GlKind frame_kind(int count, char **arguments);
/* Draws a view's floats, from malloc, by a renderer that has drawn other scenes, so that common
 * programs are not recompiled. */
float *frame_floats_by(GlContext *gl, Renderer *renderer, const Scene *scene);
/* Draws by a new renderer. */
float *frame_floats(GlContext *gl, const Scene *scene, const RendererOptions *options);
/* Draws the whole picture in tiles, last column and row first. */
float *frame_tiles(GlContext *gl, const Scene *scene, const RendererOptions *options);
/* renderer_graph with runs of spaces collapsed, so that column widths do not matter. From
 * malloc. */
char *frame_graph(const Renderer *renderer);
/* Graph of a scene that is drawn once, or the error message. From malloc. */
char *frame_graph_or_fault(GlContext *gl, const Scene *scene, const RendererOptions *options);
void frame_forget(Scene *scene, MatcDocument *document);
#endif
