/* Interface of a shadow technique: a row of this type, next to the technique's code. A light's
 * `shadows:` key selects the row by its keyword; runtime/renderer/shadow_methods.c lists all rows.
 * This folder has their shared parts: views of lights, depth maps, planes, lists of transparent
 * fragments. Its code and the lighting call the rows through the functions at the end of this
 * header. */
#ifndef MATC_SHADOW_SHADOW_METHOD_H
#define MATC_SHADOW_SHADOW_METHOD_H
#include "compiler/base/text.h"
#include "runtime/gpu_material/screen_pass.h"
#include "runtime/frame_graph/frame_pass.h"
#include "runtime/frame_graph/renderer_options.h"
#include "runtime/shadow/shadow_state.h"

enum { SHADOW_METHOD_DEFINITIONS = 256, SHADOW_METHOD_TEXTS = 3 };

/* GLSL functions of a technique that the lighting calls. Arguments are in eye space; `side` is
 * the surface's normal towards the light, `size` a pixel's size at the point.
 *   pixel  void (ivec2 pixel, float depth, vec3 point, vec4 ray, vec4 view), once per pixel; ray
 *   and view are those of view_space.h
 *   way    void (vec3 normal, vec3 l), before the shadow of a light in direction l
 *   light  vec3 (int number, ivec2 views, vec3 point, vec3 side, float size, ivec2 pixel): the
 *   share of a light that arrives, a factor on the maps' share; `number` counts the technique's
 *   lights, views.x is the light's first view and views.y their number
 *   view   SHARE (int first, int count, vec3 point, vec3 side, float size): the share by a view,
 *   or by the six of a cube, instead of percentage-closer filtering */
typedef enum {
    SHADOW_CALL_pixel,
    SHADOW_CALL_way,
    SHADOW_CALL_light,
    SHADOW_CALL_view,
    SHADOW_CALLS
} ShadowCall;

/* A technique's GLSL in a program that lights surfaces: definitions, texts that follow
 * shadow.glsl, and names of functions. NULL or empty members are omitted. */
typedef struct {
    char defined[SHADOW_METHOD_DEFINITIONS];
    const char *texts[SHADOW_METHOD_TEXTS];
    const char *calls[SHADOW_CALLS];
} ShadowMethodText;

/* Every function may be NULL. All rows are called, whether a light uses the technique or not.
 * Functions that return bool return false on failure, with a reason in the context's error. */
struct ShadowMethod {
    Keyword word; /* the technique's keyword of the list Shadows */
    size_t state; /* bytes of the technique's state in a renderer, initially zeros */

    /* Needs of the technique. */
    bool triangles; /* needs triangles of casters on the host, even if the driver displaces them */
    bool beside;    /* casters outside the view are subdivided as finely as those inside */
    bool meshes;    /* needs depth maps of triangles, not of ray-marched surfaces */
    /* handles opaque casters itself: its maps are read for transparent ones only, and have no
     * alpha-tested ones */
    bool apart;
    bool even; /* handles all casters except those of varying transparency, which are in maps */
    /* Text with which opaque surfaces' programs write the target `seen`, for the first row with
     * `seen_wanted`. */
    const TriangleIdText *seen;
    /* Return whether the row uses the target: before, and after, the scene's surfaces are known. */
    bool (*seen_wanted)(const Renderer *renderer);
    bool (*seen_needed)(const Renderer *renderer);
    /* binds the inputs of the programs with this text */
    void (*seen_bind)(const Renderer *renderer);
    /* The format of a target that the technique uses; NULL: the default. */
    const char *(*target)(const Renderer *renderer, FrameTarget target);

    /* Views of a light: cube faces overlap by a border of two texels; a directional light has
     * one view of all casters instead of cascades. */
    bool border, single;
    bool views; /* the technique's GLSL defines SHADOW_CALL_view */
    /* Returns whether silhouette crossings are found in the views. NULL: never. */
    bool (*crossed)(const Scene *scene);

    /* called after the GPU scene and views, before the frame's passes */
    bool (*make)(Renderer *renderer);
    /* called after the depth maps are made; not called without maps */
    bool (*make_maps)(Renderer *renderer);
    /* Draws the opaque casters of a view into its map; NULL: shadow_draw_cast() does. */
    void (*draw)(Renderer *renderer, const GpuSceneSource *source, int view);
    void (*drawn)(Renderer *renderer);                  /* called when all depth maps are drawn */
    bool (*changed)(Renderer *renderer, unsigned what); /* `what`: a set of FrameChange */
    /* called after these objects have moved */
    bool (*moved)(Renderer *renderer, int first, int count);
    void (*forget)(Renderer *renderer); /* frees all resources of the scene */
    void (*close)(Renderer *renderer);  /* frees all resources of the renderer */

    /* GLSL for programs that light surfaces; `nearest`: those in the depth buffer. */
    void (*text)(const Renderer *renderer, bool nearest, ShadowMethodText *made);
    void (*set)(const Renderer *renderer, ScreenPass *pass); /* sets uniforms, after each change */
    /* name of a sampler that has its own texture unit */
    const char *sampler;
    void (*bind)(const Renderer *renderer, int unit); /* binds the sampler's texture to the unit */

    void (*put)(Text *out, const Renderer *renderer); /* writes lines for --stats */
    void (*put_time)(Text *out, Renderer *renderer);

    /* Finds a debug view by its name, or returns NULL; makes its resources, with the pass tools;
     * draws it to the targets light and tools, with depth. */
    const FrameLook *(*look)(const char *name);
    bool (*look_make)(Renderer *renderer);
    void (*look_place)(Renderer *renderer); /* called when the tile or the camera has moved */
    void (*look_draw)(Renderer *renderer);

    /* Selects a variant by its keyword, for pictures side by side. False: no such variant. */
    bool (*vary)(Scene *scene, Keyword variant);
};

/* -- A renderer's rows ----------------------------------------------------------------------- */

/* Stores the rows, up to NULL, and allocates their states; frees the states and the rows'
 * resources. */
bool shadow_methods_open(Renderer *renderer, const ShadowMethod *const *methods);
void shadow_methods_close(Renderer *renderer);
/* Returns the state of a keyword's row. */
void *shadow_method_state(const Renderer *renderer, Keyword word);
/* Returns the row that a light's keyword selects; NULL: the light casts no shadows. */
const ShadowMethod *shadow_method_of(const ShadowMethod *const *methods, const SceneLight *light);
/* Returns the rows of techniques, followed by NULL. */
static inline const ShadowMethod *const *shadow_methods_of(const Renderer *renderer)
{
    return renderer->shadows->methods.rows;
}
/* Returns the number of lights with the keyword; 0 if shadows are off. */
int shadow_method_lights(const Renderer *renderer, Keyword word);
/* Returns 1 + the index of a keyword's row in the list: its number in GLSL. */
int shadow_method_number(const Renderer *renderer, Keyword word);

/* Combined needs of all lights that cast shadows: any of them, or (`even`) all of them. */
typedef struct {
    bool triangles, beside, cuts, even;
} ShadowNeeds;
ShadowNeeds shadow_methods_need(const Renderer *renderer);
/* Return the first row that wants the target `seen`, or NULL; and whether it needs the target
 * now. */
const ShadowMethod *shadow_method_seen(const Renderer *renderer);
bool shadow_method_sees(const Renderer *renderer);
void shadow_method_seen_bind(const Renderer *renderer);
/* Returns whether the view shows the picture or its lighting. */
bool shadow_shows_light(const Renderer *renderer);
/* Returns whether the driver supports one more target in addition to those of the G-buffer. */
bool shadow_seen_fits(const Renderer *renderer);
/* Returns the format of a target by the first row that defines it; NULL: none does. */
const char *shadow_methods_target(const Renderer *renderer, FrameTarget target);
bool shadow_methods_make(Renderer *renderer);
/* Finds a debug view by its name; NULL: unknown to all rows. */
const FrameLook *shadow_methods_look(const ShadowMethod *const *methods, const char *name);
bool shadow_methods_look_make(Renderer *renderer);
void shadow_methods_look_place(Renderer *renderer);
void shadow_methods_look_draw(Renderer *renderer);
#endif
