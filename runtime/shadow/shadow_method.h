/* A shadow technique is a row of this type, beside the technique's code. A light's `shadows:` key
 * selects the row by its word; runtime/render/shadow_methods.c lists all rows. This folder has what
 * they share: views of lights, depth maps, planes, lists of transparent fragments. Its code and the
 * lighting call the rows through the functions at the end of this header. */
#ifndef MATC_SHADOW_SHADOW_METHOD_H
#define MATC_SHADOW_SHADOW_METHOD_H
#include "compiler/base/text.h"
#include "runtime/draw/screen_pass.h"
#include "runtime/frame/frame_pass.h"
#include "runtime/frame/render_options.h"
#include "runtime/shadow/shadow_state.h"

enum { SHADOW_METHOD_DEFINITIONS = 256, SHADOW_METHOD_TEXTS = 3 };

/* GLSL functions of a method that the lighting calls. Arguments are in the eye's space; `side` is
 * the surface's normal towards the light, `size` that of a pixel at the point.
 *   pixel  void (ivec2 pixel, float depth, vec3 point, vec4 ray, vec4 view), once for a pixel; ray
 *          and view are those of view_space.h
 *   way    void (vec3 normal, vec3 l), before a light in direction l is shadowed
 *   light  vec3 (int number, ivec2 views, vec3 point, vec3 side, float size, ivec2 pixel): the
 *          share of a light that arrives, by which the maps' share is multiplied; `number` counts
 *          the method's lights, views.x is the light's first view and views.y how many it has
 *   view   SHARE (int first, int count, vec3 point, vec3 side, float size): the share by a view, or
 *          by the six of a cube, in place of filtered depths */
typedef enum {
    SHADOW_CALL_pixel,
    SHADOW_CALL_way,
    SHADOW_CALL_light,
    SHADOW_CALL_view,
    SHADOW_CALLS
} ShadowCall;

/* A method's GLSL in a program that lights surfaces: definitions, texts behind shadow.glsl, and
 * names of functions. What is NULL or empty is left out. */
typedef struct {
    char defined[SHADOW_METHOD_DEFINITIONS];
    const char *texts[SHADOW_METHOD_TEXTS];
    const char *calls[SHADOW_CALLS];
} ShadowMethodText;

/* Every function may be NULL. All rows are called, whether a light has the method or not. Functions
 * that return bool return false on failure, with a reason in the context's error. */
struct ShadowMethod {
    Word word;    /* of the list Shadows */
    size_t state; /* bytes of its state in a renderer, which begin as zeros */

    /* Needs */
    bool triangles; /* triangles of casters on the host, even if the driver displaces them */
    bool beside;    /* casters beside the view as finely divided as those in view */
    bool meshes;    /* depth maps of triangles, not of ray-marched surfaces */
    bool apart;     /* it has opaque casters apart from its maps, which are asked for transparent
                     * ones alone and have no alpha-tested ones */
    bool even; /* it has all casters but those whose transparency varies: maps have the others */
    /* Text with which programs of opaque surfaces write the target `seen`, for the first row that
     * wants it; whether the row wants it, before and after the scene's surfaces are known. */
    const SeenText *seen;
    bool (*seen_wanted)(const Render *render);
    bool (*seen_needed)(const Render *render);
    void (*seen_bind)(const Render *render); /* what these programs read */
    /* The format of a target that the method uses; NULL: as without it. */
    const char *(*target)(const Render *render, FrameTarget target);

    /* Views of a light: faces of a cube overlap by a border of two texels; a directional light has
     * one view of all casters instead of cascades; crossings of silhouettes are found (NULL:
     * never). */
    bool border, single;
    bool views; /* its GLSL has SHADOW_CALL_view */
    bool (*crossed)(const Scene *scene);

    bool (*make)(Render *render);      /* after the cache and views, before the frame's passes */
    bool (*make_maps)(Render *render); /* after the depth maps; not called without any */
    /* Draws the opaque casters of a view into its map; NULL: shadow_draw_cast() does. */
    void (*draw)(Render *render, const CacheSource *source, int view);
    void (*drawn)(Render *render);                       /* all depth maps are drawn */
    bool (*changed)(Render *render, unsigned what);      /* a set of FrameChange */
    bool (*moved)(Render *render, int first, int count); /* these objects have moved */
    void (*forget)(Render *render);                      /* frees all resources of the scene */
    void (*close)(Render *render);                       /* and those of the renderer */

    /* For programs that light surfaces: `nearest`, what the depth buffer has. */
    void (*text)(const Render *render, bool nearest, ShadowMethodText *made);
    void (*set)(const Render *render, ScreenPass *pass); /* uniforms, after each change */
    const char *sampler;                                 /* reads a texture unit of its own, */
    void (*bind)(const Render *render, int unit);        /* at which this binds what it reads */

    void (*put)(Text *out, const Render *render); /* lines for --stats */
    void (*put_time)(Text *out, Render *render);

    /* A debug view of the picture by its name, or NULL; what it takes, made with the pass tools,
     * and drawn to light and tools with depth. */
    const FrameLook *(*look)(const char *name);
    bool (*look_make)(Render *render);
    void (*look_place)(Render *render); /* the tile or the camera has moved */
    void (*look_draw)(Render *render);

    /* Variants for pictures side by side: selects the one of that word. False: it has none of it.
     */
    bool (*vary)(Scene *scene, Word variant);
};

/* -- A renderer's rows ----------------------------------------------------------------------- */

/* Takes the rows, up to NULL, and makes their states; frees these, and what rows hold. */
bool shadow_methods_open(Render *render, const ShadowMethod *const *methods);
void shadow_methods_close(Render *render);
/* The state of a word's row. */
void *shadow_method_state(const Render *render, Word word);
/* The row that a light's word selects; NULL: it casts no shadows. */
const ShadowMethod *shadow_method_of(const ShadowMethod *const *methods, const SceneLight *light);
/* The rows, up to NULL. */
static inline const ShadowMethod *const *shadow_methods_of(const Render *render)
{
    return render->shadows->methods.rows;
}
/* How many lights have the word; 0 if shadows are off. */
int shadow_method_lights(const Render *render, Word word);
/* 1 + the place of a word's row in the list: its number in GLSL. */
int shadow_method_number(const Render *render, Word word);

/* Needs of all lights that cast shadows: of some of them, and (`even`) of each. */
typedef struct {
    bool triangles, beside, cuts, even;
} ShadowNeeds;
ShadowNeeds shadow_methods_need(const Render *render);
/* The first row that wants the target `seen`, or NULL; and whether it needs it. */
const ShadowMethod *shadow_method_seen(const Render *render);
bool shadow_method_sees(const Render *render);
void shadow_method_seen_bind(const Render *render);
/* The view is the picture or its light. */
bool shadow_shows_light(const Render *render);
/* The driver has room for that target beside those of the G-buffer. */
bool shadow_seen_fits(const Render *render);
/* The format of a target by the first row that says one; NULL: none does. */
const char *shadow_methods_target(const Render *render, FrameTarget target);
bool shadow_methods_make(Render *render);
/* A debug view by its name; NULL: no row has it. */
const FrameLook *shadow_methods_look(const ShadowMethod *const *methods, const char *name);
bool shadow_methods_look_make(Render *render);
void shadow_methods_look_place(Render *render);
void shadow_methods_look_draw(Render *render);
#endif
