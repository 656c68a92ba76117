/* Hybrid shadows: state of the shadow volumes in a renderer, and the functions that draw them. */
#ifndef MATC_SHADOW_VOLUME_H
#define MATC_SHADOW_VOLUME_H
#include "runtime/shadow/shadow_method.h"
#include "runtime/gl/framebuffer.h"

enum {
    VOLUME_LIGHTS = 32,   /* max lights with hybrid shadows in a scene: bits of the mask */
    VOLUME_AUTO_MIB = 256 /* memory limit of buffers for the path auto */
};

/* State of a scene's shadow volumes, for pass_volume.c, volume_data.c and volume_blur.c. */
typedef struct {
    /* Programs by view, for hybrid views; caps for perspective ones. */
    Material *sheets, *caps;
    Material *marks; /* programs that mark the mask, indexed by hybrid light */
    Material *shown; /* programs of a debug view, like `sheets`; NULL: none */
    int view_count, light_count;
    GLuint array; /* vertex array without attributes, for caps and cells */
    Keyword path; /* path of volume_data.c that fills the members below; never auto */
    GLuint *arrays;
    int array_count;          /* number of arrays: 1, or the number of hybrid views */
    GLuint indices, vertices; /* index and vertex buffers; 0: vertices read the depth map */
    GLsizei index_count;      /* number of indices per view */
    Material writer;
    Framebuffer corners; /* corners of quads, 2 x 2 texels each, before they are copied */
    Material blur;
    GLuint sharp;           /* texture of the depths before blurring */
    GLuint cells, commands; /* buffers of volume_cells.c: lists of cells, and draw commands */
} FrameVolumes;

static inline FrameVolumes *volume_state(const Renderer *renderer)
{
    return shadow_method_state(renderer, KEYWORD_Shadows_hybrid);
}
/* Returns the number of lights with hybrid shadows. */
static inline int volume_lights_count(const Renderer *renderer)
{
    return shadow_method_lights(renderer, KEYWORD_Shadows_hybrid);
}
/* Returns whether some light casts hybrid shadows, and some object does. */
static inline bool volume_lights_cast(const Renderer *renderer)
{
    return renderer->shadows->views.count > 0 && volume_lights_count(renderer) > 0;
}
/* Returns whether the view belongs to a light with hybrid shadows. */
static inline bool volume_has_view(const Renderer *renderer, int view)
{
    return renderer->shadows->views.views[view].method->word == KEYWORD_Shadows_hybrid;
}

/* -- Depth blurring, for `volume: blurred` (volume_blur.c) ------------------------------------- */

bool volume_blur_make(Renderer *renderer);
/* Attaches the texture of unblurred depths as the depth target. */
void volume_blur_use(const Renderer *renderer);
/* Draws the blurred depths to the bound map. */
void volume_blur_draw(Renderer *renderer);
void volume_blur_delete(Renderer *renderer);

/* -- Vertices, by the scene's path (volume_data.c) --------------------------------------------- */

bool volume_data_make(Renderer *renderer);
/* Writes the buffers, after the maps are drawn. */
void volume_data_write(Renderer *renderer);
/* Returns the macro definitions of the vertex program; `shown`: for a debug view. */
const char *volume_data_text(const Renderer *renderer, bool shown);
void volume_data_draw(const Renderer *renderer, int view, bool shown);
/* Appends a line for --stats. */
void volume_data_put(Text *out, const Renderer *renderer);
void volume_data_delete(Renderer *renderer);

/* -- Volumes cut at silhouettes (volume_cells.c) ----------------------------------------------- */

/* Returns whether the scene has `volume: silhouette`. */
bool volume_cells_are(const Renderer *renderer);
bool volume_cells_make(Renderer *renderer);
/* Lists the cells of all views, after the maps are drawn. */
void volume_cells_write(Renderer *renderer);
/* Returns the macro definitions of the vertex program that draws listed cells, or all. */
const char *volume_cells_head(bool listed);
/* Returns GLSL declarations of the samplers that volume_cells.glsl reads. */
const char *volume_cells_maps(void);
/* Draws the listed cells of a view; `number` is its index among hybrid views. */
void volume_cells_draw(const Renderer *renderer, int view, int number);
/* Draws all cells in a fixed order, for a view that blends colors. */
void volume_cells_draw_all(const Renderer *renderer, int view, int number);
/* Returns the size of the lists of cells in bytes. */
size_t volume_cells_bytes(const Renderer *renderer);
void volume_cells_delete(Renderer *renderer);

/* -- Debug views (volume_shown.c) -------------------------------------------------------------- */

/* Finds a debug view of the technique by its name; NULL: unknown. */
const FrameLook *volume_shown_find(const char *name);
/* Volumes in a debug view: made after the maps; updated for a new camera or tile; drawn to the
 * targets light and tools, with depth. */
bool volume_shown_make(Renderer *renderer);
void volume_shown_place(Renderer *renderer);
void volume_shown_draw(Renderer *renderer);

/* Sets the uniforms of volume_vertex.glsl for a view of a light; returns the version line of its
 * text. */
void pass_volume_place(const Renderer *renderer, int number, Material *material);
const char *pass_volume_head(const Renderer *renderer);
extern const FramePass pass_volume;
#endif
