/* The renderer: draws scenes with matc's programs, on a context that the caller made and that is
 * current at every call.
 *
 *     Renderer *render = renderer_open(gl, &(RendererOptions){.compile = &options});
 *     if (render && renderer_set_scene(render, scene) && renderer_frame(render))
 *         renderer_read(render, rgba);
 *     renderer_close(render);
 *
 * A function that returns false or NULL leaves the reason in the context's error. */
#ifndef MATC_RENDERER_RENDERER_H
#define MATC_RENDERER_RENDERER_H
#include "runtime/frame_graph/renderer_options.h"
#include "runtime/gl/context.h"
#include "runtime/scene/scene.h"

/* Returns the present name of a view: versions before 0.2 named "final" "shown" and "ao"
 * "open". NULL stays NULL, any other name stays as it is. */
const char *renderer_view_canonical(const char *view);
/* Reports whether the view is the picture: "final", or a debug view with lines or shadow
 * volumes. */
bool renderer_view_is_picture(const char *view);
/* Opens a renderer. Returns NULL on failure; see gl->error. */
Renderer *renderer_open(GlContext *gl, const RendererOptions *options);
/* Closes a renderer and frees all its resources. Does nothing for NULL. */
void renderer_close(Renderer *renderer);

/* Makes the resources for drawing a scene. The scene is not copied: it must exist until the next
 * one is set or the renderer is closed. Reuses programs, textures and meshes of the previous
 * scene, and frees those that are no longer needed. */
bool renderer_set_scene(Renderer *renderer, const Scene *scene);
/* Applies changes to the scene, a set of RendererChange. */
bool renderer_changed(Renderer *renderer, unsigned what);
/* Applies new matrices of `count` objects from `first` on. */
bool renderer_changed_objects(Renderer *renderer, int first, int count);
/* Rebuilds after objects got other meshes, or meshes changed. Keeps the values of material
 * parameters. */
bool renderer_changed_meshes(Renderer *renderer);
/* Rebuilds the previous scene, after a rebuild with changes has failed and the changes were
 * undone. */
bool renderer_rebuild(Renderer *renderer, const Scene *scene);
/* Sets the picture's size in pixels; 0: the scene's size. Returns false and changes nothing if
 * the targets cannot be made. */
bool renderer_resize(Renderer *renderer, int width, int height);
/* Sets a parameter of a material, which is an index in scene->materials. Returns false if none
 * of its programs has a parameter with the given name and number of components, 1 to 4. */
bool renderer_param(Renderer *renderer, int material, const char *name, const float *components,
                    int count);
/* Draws a frame. If nothing has changed since the previous frame, the only GL calls are those
 * that bind, clear, draw and dispatch. */
bool renderer_frame(Renderer *renderer);

/* Size of the picture, and of a tile, in pixels. */
int renderer_width(const Renderer *renderer);
int renderer_height(const Renderer *renderer);
int renderer_tile_width(const Renderer *renderer);
int renderer_tile_height(const Renderer *renderer);
/* Moves the tile: the next frame begins with pixel (x, y) of the picture, from the lower left
 * corner. Both numbers are even, so that blocks of 2 x 2 pixels stay together. Pixels outside
 * the picture are drawn, too, and have no meaning. */
void renderer_set_tile(Renderer *renderer, int x, int y);
/* Returns the components of the view: 4 for light, 1 for depth; for a slot its own number, but 3
 * instead of 2. */
int renderer_components(const Renderer *renderer);
/* Reads the tile's view, four floats per pixel, row 0 at the bottom: "final" is sRGB, "light" is
 * linear, "depth" is in the first component. For depth and slots the last component is the
 * pixel's coverage by surfaces. */
bool renderer_read(Renderer *renderer, float *rgba);

/* Shadow maps: their number, their edge in texels, and the depths of a map as its technique left
 * them, row 0 at the bottom. Background is 0; otherwise depth is near / distance, or, for
 * parallel light, 1 to 0.5 (shadow_views.h). Call after a frame was drawn. */
int renderer_map_count(const Renderer *renderer);
int renderer_map_size(const Renderer *renderer);
bool renderer_read_map(Renderer *renderer, int map, float *depths);

/* Selects a variant of a shadow technique; both are keywords. Returns the variant's name; NULL
 * if it is unknown. */
const char *renderer_shadows_vary(Scene *scene, Keyword method, Keyword variant);

/* Reports whether the view is a slot that the scene's layout does not store, and that reads as
 * 0. */
bool renderer_missing_view(const Renderer *renderer);
/* Returns the warnings of the scene's programs, with their places, and a warning if no object is
 * in view. From malloc. */
char *renderer_diagnostics(const Renderer *renderer);

/* Time of a pass, measured by drawing it once more: by the driver's timer query if supported
 * (clock.h), else until glFinish returns. 0 if the pass does not run. */
typedef struct {
    const char *name;
    double seconds;
} RendererPassTime;
enum { RENDERER_PASSES_MAX = 32 };
/* Measures all passes in the order of a frame; shadow maps are drawn again. Returns the number
 * of passes. */
int renderer_time_passes(Renderer *renderer, RendererPassTime times[RENDERER_PASSES_MAX]);
/* Bytes of a pixel in all targets, and of a fragment in a linked list; 0 without lists. */
int renderer_pixel_bytes(const Renderer *renderer);
int renderer_fragment_bytes(const Renderer *renderer);

/* Returns a description of the frame graph: each pass's inputs and outputs, whether it runs and
 * why not; the targets, their bytes and shared memory. From malloc. */
char *renderer_graph(const Renderer *renderer);
/* Returns the frame graph with the time of each pass, drawn once more, and with numbers of
 * programs, triangles and bytes. From malloc. NULL on failure; see the context's error. */
char *renderer_stats(Renderer *renderer);
#endif
