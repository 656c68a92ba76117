/* The renderer: draws scenes with matc's programs, on a context that the caller made and that is
 * current at every call.
 *
 *     Render *render = render_open(gl, &(RenderOptions){.compile = &options});
 *     if (render && render_scene(render, scene) && render_frame(render))
 *         render_read(render, rgba);
 *     render_close(render);
 *
 * A function that returns false or NULL leaves the reason in the context's error. */
#ifndef MATC_RENDER_RENDER_H
#define MATC_RENDER_RENDER_H
#include "runtime/frame/render_options.h"
#include "runtime/gl/context.h"
#include "runtime/scene/scene.h"

/* Reports whether the view is the picture: "shown", or a debug view with lines or shadow
 * volumes. */
bool render_view_is_picture(const char *view);
/* Opens a renderer. Returns NULL on failure; see gl->error. */
Render *render_open(GlContext *gl, const RenderOptions *options);
/* Closes a renderer and frees all its resources. Does nothing for NULL. */
void render_close(Render *render);

/* Makes the resources for drawing a scene. The scene is not copied: it must exist until the next
 * one is set or the renderer is closed. Reuses programs, textures and meshes of the previous
 * scene, and frees those that are no longer needed. */
bool render_scene(Render *render, const Scene *scene);
/* Applies changes to the scene, a set of RenderChange. */
bool render_changed(Render *render, unsigned what);
/* Applies new matrices of `count` objects from `first` on. */
bool render_changed_objects(Render *render, int first, int count);
/* Rebuilds after objects got other meshes, or meshes changed. Keeps the values of material
 * parameters. */
bool render_changed_meshes(Render *render);
/* Rebuilds the previous scene, after a rebuild with changes has failed and the changes were
 * undone. */
bool render_again(Render *render, const Scene *scene);
/* Sets the picture's size in pixels; 0: the scene's size. Returns false and changes nothing if
 * the targets cannot be made. */
bool render_resize(Render *render, int width, int height);
/* Sets a parameter of a material, which is an index in scene->materials. Returns false if none
 * of its programs has a parameter of that name and number of components, 1 to 4. */
bool render_param(Render *render, int material, const char *name, const float *lanes, int count);
/* Draws a frame. If nothing has changed since the previous frame, the only GL calls are those
 * that bind, clear, draw and dispatch. */
bool render_frame(Render *render);

/* Size of the picture, and of a tile, in pixels. */
int render_width(const Render *render);
int render_height(const Render *render);
int render_tile_width(const Render *render);
int render_tile_height(const Render *render);
/* Moves the tile: the next frame begins with pixel (x, y) of the picture, from the lower left
 * corner. Both numbers are even, so that blocks of 2 x 2 pixels stay together. Pixels outside
 * the picture are drawn, too, and have no meaning. */
void render_move(Render *render, int x, int y);
/* Returns the components of the view: 4 for light, 1 for depth; for a slot its own number, but 3
 * instead of 2. */
int render_lanes(const Render *render);
/* Reads the tile's view, four floats per pixel, row 0 at the bottom: "shown" is sRGB, "light" is
 * linear, "depth" is in the first component. For depth and slots the last component is the
 * pixel's coverage by surfaces. */
bool render_read(Render *render, float *rgba);

/* Shadow maps: their number, their edge in texels, and the depths of a map as its technique left
 * them, row 0 at the bottom. Background is 0; otherwise depth is near / distance, or, for
 * parallel light, 1 to 0.5 (shadow_views.h). Call after a frame was drawn. */
int render_map_count(const Render *render);
int render_map_size(const Render *render);
bool render_read_map(Render *render, int map, float *depths);

/* Selects a variant of a shadow technique; both are keywords. Returns the variant's name; NULL
 * if it is unknown. */
const char *render_shadows_vary(Scene *scene, Word method, Word variant);

/* Reports whether the view is a slot that the scene's layout does not store, and that reads as
 * 0. */
bool render_lacks_view(const Render *render);
/* Returns the warnings of the scene's programs, with their places, and a warning if no object is
 * in view. From malloc. */
char *render_diagnostics(const Render *render);

/* Time of a pass, measured by drawing it once more: by the driver's timer query if supported
 * (clock.h), else until glFinish returns. 0 if the pass does not run. */
typedef struct {
    const char *name;
    double seconds;
} RenderPassTime;
enum { RENDER_PASSES_MOST = 32 };
/* Measures all passes in the order of a frame; shadow maps are drawn again. Returns the number
 * of passes. */
int render_time_passes(Render *render, RenderPassTime times[RENDER_PASSES_MOST]);
/* Bytes of a pixel in all targets, and of a fragment in a linked list; 0 without lists. */
int render_pixel_bytes(const Render *render);
int render_fragment_bytes(const Render *render);

/* Returns a description of the frame graph: each pass's inputs and outputs, whether it runs and
 * why not; the targets, their bytes and shared memory. From malloc. */
char *render_graph(const Render *render);
/* Returns the frame graph with the time of each pass, drawn once more, and with numbers of
 * programs, triangles and bytes. From malloc. NULL on failure; see the context's error. */
char *render_stats(Render *render);
#endif
