/* Hybrid shadows: what a renderer keeps of shadow volumes, and what draws them. */
#ifndef MATC_SHADOW_VOLUME_H
#define MATC_SHADOW_VOLUME_H
#include "runtime/shadow/shadow_method.h"
#include "runtime/gl/framebuffer.h"

enum {
    VOLUME_LIGHTS = 32,   /* with hybrid shadows, in a scene: bits of the mask */
    VOLUME_AUTO_MIB = 256 /* that the path auto may take for buffers */
};

/* State for a scene: of pass_volume.c, volume_data.c and volume_blur.c. */
typedef struct {
    /* by view, of those that are hybrid; caps of those that are perspective */
    Material *sheets, *caps;
    Material *marks; /* of each hybrid light */
    Material *shown; /* as sheets, to be looked at; NULL: they are not */
    int view_count, light_count;
    GLuint array; /* of caps and cells, whose vertices have no numbers but their own */
    Word path;    /* of volume_data.c, as is what follows; never auto */
    GLuint *arrays;
    int array_count;          /* one, or as many as views of hybrid lights */
    GLuint indices, vertices; /* 0: these fetch all */
    GLsizei index_count;      /* of a view */
    Material writer;
    Framebuffer corners; /* of quads, two by two texels each, before they are copied */
    Material blur;
    GLuint sharp;           /* depths before they are blurred */
    GLuint cells, commands; /* of volume_cells.c: buffers of lists of cells, and of draws */
} FrameVolumes;

static inline FrameVolumes *volume_state(const Render *render)
{
    return shadow_method_state(render, WORD_Shadows_hybrid);
}
/* How many lights cast hybrid shadows; one does, and there is something that casts; a view is of
 * such a light. */
static inline int volume_lights_count(const Render *render)
{
    return shadow_method_lights(render, WORD_Shadows_hybrid);
}
static inline bool volume_lights_cast(const Render *render)
{
    return render->shadows->views.count > 0 && volume_lights_count(render) > 0;
}
static inline bool volume_has_view(const Render *render, int view)
{
    return render->shadows->views.views[view].method->word == WORD_Shadows_hybrid;
}

/* Where depths are blurred: what that takes; depth is drawn to what will be; its means to what is
 * drawn to. volume_blur.c */
bool volume_blur_make(Render *render);
void volume_blur_use(const Render *render);
void volume_blur_draw(Render *render);
void volume_blur_delete(Render *render);

/* Vertices by the scene's path: made; written, when maps have been drawn; what the vertex program
 * goes by, which is to be looked at or not; a view's drawn; a line on them; deleted.
 * volume_data.c */
bool volume_data_make(Render *render);
void volume_data_write(Render *render);
const char *volume_data_text(const Render *render, bool shown);
void volume_data_draw(const Render *render, int view, bool shown);
void volume_data_put(Text *out, const Render *render);
void volume_data_delete(Render *render);

/* Volumes cut by silhouettes: whether they are; the samplers that volume_cells.glsl reads; drawing
 * only cells in lists, or all of them in one order, for a view that blends colors; bytes of the
 * lists. volume_cells.c */
bool volume_cells_are(const Render *render);
bool volume_cells_make(Render *render);
void volume_cells_write(Render *render);
const char *volume_cells_head(bool listed);
const char *volume_cells_maps(void);
void volume_cells_draw(const Render *render, int view, int number);
void volume_cells_draw_all(const Render *render, int view, int number);
size_t volume_cells_bytes(const Render *render);
void volume_cells_delete(Render *render);
/* A debug view by its name; NULL: it is another one. volume_shown.c */
const FrameLook *volume_shown_find(const char *name);
/* Volumes in the pass tools: made once maps are made; placed for another view; drawn, to light and
 * to tools with depth. */
bool volume_shown_make(Render *render);
void volume_shown_place(Render *render);
void volume_shown_draw(Render *render);

/* Sets the uniforms of volume_vertex.glsl for a view of a light; begins its text. */
void pass_volume_place(const Render *render, int number, Material *material);
const char *pass_volume_head(const Render *render);
extern const FramePass pass_volume;
#endif
