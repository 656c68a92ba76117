/* Draws scenes for tests: a failure ends the test and prints its reason. */
#ifndef MATC_FRAME_DRAW_H
#define MATC_FRAME_DRAW_H
#include "runtime/renderer/renderer.h"
#include "runtime/scene_reader/scene_read.h"

/* The layout `integer`, exact powers, no averages over pixels: references have points. */
MatcOptions frame_exact_options(void);
/* Every number as it is: what is then off is what the passes are. The layout goes behind all that
 * is drawn with it. */
MatcOptions frame_float_options(MatcLayout **layout);
Scene *frame_scene(const char *text, const MatcOptions *options, MatcDocument **document);
GlContext *frame_context(void);
GlContext *frame_context_of(GlKind kind);
/* The kind that a test's last argument names, as in `build/tests/test_x egl`; else OSMesa. */
GlKind frame_kind(int count, char **arguments);
/* Floats of a view, from malloc; by a renderer that has drawn other scenes: what these have in
 * common is not compiled again. */
float *frame_floats_by(GlContext *gl, Renderer *renderer, const Scene *scene);
/* By one of its own. */
float *frame_floats(GlContext *gl, const Scene *scene, const RendererOptions *options);
/* Draws the whole picture by its tiles, the last column and row first. */
float *frame_tiles(GlContext *gl, const Scene *scene, const RendererOptions *options);
/* renderer_graph with one space between words, so that columns may move. From malloc. */
char *frame_graph(const Renderer *renderer);
/* Graph of a scene that is drawn once; or why it cannot be drawn. From malloc. */
char *frame_graph_or_fault(GlContext *gl, const Scene *scene, const RendererOptions *options);
void frame_forget(Scene *scene, MatcDocument *document);
#endif
