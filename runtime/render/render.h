/* The renderer: scenes drawn with matc's programs, on a context that the caller made and that is
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

/* The view is "shown", or the picture with lines for surfaces, or with shadow volumes. */
bool render_view_is_picture(const char *view);
/* Opens a renderer. NULL: see gl->error. */
Render *render_open(GlContext *gl, const RenderOptions *options);
/* With all that it made. NULL is nothing. */
void render_close(Render *render);

/* Makes what drawing the scene takes; the scene is not kept, but is there until the next one, or
 * the end. Further frames need no more. Programs, pictures and meshes that the scene before had are
 * not made again; what nobody needs any more goes. */
bool render_scene(Render *render, const Scene *scene);
/* Tells what was changed: a sum of RenderChange. */
bool render_changed(Render *render, unsigned what);
/* So many objects from `first` on have other matrices. */
bool render_changed_objects(Render *render, int first, int count);
/* Objects have other meshes, or other ones have changed: what is made of them is made anew. Params
 * stay as they were set. */
bool render_changed_meshes(Render *render);
/* Rebuilds the scene that was drawn, after rebuilding has failed and the scene is as before. */
bool render_again(Render *render, const Scene *scene);
/* Draws pictures of so many pixels from now on; 0: as the scene says. False: the targets cannot be
 * made, and all is as it was. */
bool render_resize(Render *render, int width, int height);
/* Sets a param of a material, by its place in scene->materials. False: none of its programs has a
 * param of that name and so many lanes, 1 to 4. */
bool render_param(Render *render, int material, const char *name, const float *lanes, int count);
/* Draws. A frame makes no GL call but those that bind, clear, draw and dispatch, where nothing was
 * changed since the one before. */
bool render_frame(Render *render);

/* Size of the picture, and of the part that is drawn at once. */
int render_width(const Render *render);
int render_height(const Render *render);
int render_tile_width(const Render *render);
int render_tile_height(const Render *render);
/* The next frame begins with that pixel of the picture, from its lower left corner; even numbers,
 * so that pixels keep their neighbours in a block of 2 x 2. What lies beyond the picture is drawn,
 * too, and of no use. */
void render_move(Render *render, int x, int y);
/* Components of the view: 4 for light, 1 for depth, those of a slot, and 3 if a slot has 2. */
int render_lanes(const Render *render);
/* The view of the tile, four floats a pixel, row 0 is the bottom row: "shown" is sRGB, "light"
 * linear, "depth" in the first lane. Of depth and of slots the last lane is the share of the pixel
 * where a surface is. */
bool render_read(Render *render, float *rgba);

/* Maps of depth as lights see them: how many there are, their edge in texels, and what one holds,
 * row 0 at the bottom, as its method left it. 0 is where nothing is; else near / distance, or, of
 * parallel light, from 1 to 0.5 (shadow_views.h). There is a frame. */
int render_map_count(const Render *render);
int render_map_size(const Render *render);
bool render_read_map(Render *render, int map, float *depths);

/* Selects a variant, by its word, of a technique of the list Shadows. Its name; NULL: there is
 * none. */
const char *render_shadows_vary(Scene *scene, Word method, Word variant);

/* The view is a slot that the scene's layout does not store: it is read as 0. */
bool render_lacks_view(const Render *render);
/* Warnings of the scene's programs, with their places; and that no object is in view. From
 * malloc. */
char *render_diagnostics(const Render *render);

/* Time of a pass, drawn once more: by the driver's clock if it has one (clock.h), else until it was
 * finished; 0: it does not run. */
typedef struct {
    const char *name;
    double seconds;
} RenderPassTime;
enum { RENDER_PASSES_MOST = 32 };
/* Times of all passes, in the order of a frame; shadow maps are drawn again. Returns how many. */
int render_time_passes(Render *render, RenderPassTime times[RENDER_PASSES_MOST]);
/* Bytes of a pixel in all targets; of a fragment in a list, 0: there are no lists. */
int render_pixel_bytes(const Render *render);
int render_fragment_bytes(const Render *render);

/* The passes: what each reads and writes, which run, and why not; targets, their bytes and which
 * share memory. From malloc. */
char *render_graph(const Render *render);
/* The graph with the times of a frame, drawn once more pass by pass; programs, triangles, bytes.
 * From malloc. NULL: see the context's error. */
char *render_stats(Render *render);
#endif
