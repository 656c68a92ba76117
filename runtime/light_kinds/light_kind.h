/* Kinds of lights. A light is data, SceneLight. Its kind is a row, LightKind, which says where its
 * light comes from, reads its own parameters, and has its GLSL. Only the files of a kind and the
 * list light_kinds.def name a kind; all other code asks the row. docs/design/add-a-light.md adds
 * one.
 *
 * Lengths are in the world's units and axes, positions relative to Scene.origin. */
#ifndef MATC_LIGHT_KIND_H
#define MATC_LIGHT_KIND_H
#include "compiler/base/diag.h"
#include "grammar/scene_tables.h"

typedef struct {
    SceneKind kind; /* of the sort light */
    double position[3];
    double direction[3];               /* in which it shines; unit length */
    double light[3];                   /* intensity times color */
    double ground[3];                  /* from around: the same from below */
    double inner_cosine, outer_cosine; /* of a cone: inner >= outer */
    double edges[2][3];                /* of an extent */
    bool both_sides;                   /* of an extent: its back shines, too */
    const char *name;                  /* NULL: it has none */
    /* how objects cast shadows in its light: WORD_Shadows_none, ... */
    Word shadows;
} SceneLight;

/* Where light comes from. This decides on shadows: a point has the views of a cube or a cone, light
 * from afar has parallel views, an extent has a view for each of several points. */
typedef enum {
    LIGHT_FROM_point,  /* the position */
    LIGHT_FROM_afar,   /* parallel, along the direction */
    LIGHT_FROM_extent, /* position + s edges[0] + t edges[1], s and t from 0 to 1 */
    LIGHT_FROM_around, /* all directions, without shadows; lights of the kind are summed */
    LIGHT_FROM_sky     /* the scene's sky: it is no SceneLight, and scales Scene.sky_light */
} LightFrom;

/* The numbers that a document gives a light, or their defaults, by their places in the kind's run
 * of scene_param_table. */
typedef struct {
    SceneKind kind;
    double at[SCENE_KIND_PARAMS][3];
} LightParams;

/* A fault of the value of a parameter; `text`: what the message quotes, or NULL. */
typedef struct {
    DiagKind diag;
    int param;
    const char *text;
} LightFault;

/* Receives the lines that show a light as a tool. */
typedef struct LightLines {
    void (*add)(struct LightLines *lines, const double from[3], const double to[3]);
    double size;    /* of a cross, a cone's edges, a quarter of an arrow */
    double zero[3]; /* the world's origin */
} LightLines;

/* The GLSL of a kind is read twice: before the surface models, and behind lighting.glsl with
 * LIGHT_SENDS defined. In the second it defines, by the name of the kind,
 *
 *     vec3 lightFromArea(int light, Seen seen)   what a surface sends of a light that has a place
 *     vec3 lightFromAmbient(Seen seen)           or of all light from around
 *
 * and finds a light's numbers by lightTexel() (light.layout.def). A light from around has a uniform
 * block of the kind's name: up, the light from above and that from below, as three vec4. */
typedef struct {
    SceneKind kind;
    LightFrom from;
    /* From around, and radiance differs by direction: the GLSL defines, without LIGHT_SENDS,
     * vec3 lightAlongHemisphere(vec3 direction). */
    bool varies;
    /* NULL: the formula of points and parallel light in lighting.glsl, which has a cone. */
    const char *glsl;
    /* Reads parameters other than position, direction, color, intensity, shadows and name, which
     * all kinds share. False: a fault. NULL: there are none. */
    bool (*read)(const LightParams *params, SceneLight *light, LightFault *fault);
    /* Light within a cone: its share s s (3 - 2 s), s = clamp(scale cosine + shift, 0, 1) of the
     * angle from the direction. NULL: the same in all directions. */
    void (*cone)(const SceneLight *light, double scale_shift[2]);
    /* Draws it as a tool. NULL: nothing. */
    void (*outline)(const SceneLight *light, LightLines *lines);
} LightKind;

/* All kinds, then NULL: the rows of light_kinds.def. */
enum { LIGHT_KINDS_MAX = 16 };
extern const LightKind *const light_kind_table[LIGHT_KINDS_MAX + 1];

/* The number of a light's kind in the table, and its row. */
int light_kind_number(SceneKind kind);
const LightKind *light_kind_of(const SceneLight *light);
const char *light_kind_name(const LightKind *row);
static inline LightFrom light_from(const SceneLight *light) { return light_kind_of(light)->from; }

/* Three numbers of a parameter, of which a number has the first. */
const double *light_params_at(const LightParams *params, int param);

/* A cone wider than this cosine of its half angle is seen as a point that shines all around: a cube
 * has finer texels than one wide view. */
#define LIGHT_KIND_WIDEST 0.5
/* A point that shines all around, or whose cone is that wide. */
bool light_kind_is_wide(const SceneLight *light);

/* The point at a distance from the light, angles[0] off its direction and angles[1] around it. */
void light_kind_around(const SceneLight *light, const double angles[2], double distance,
                       double out[3]);

/* Lights without shadows that the renderer makes by itself; the caller sets what they are like. */
SceneLight light_directional_new(const double direction[3], const double light[3]);
SceneLight light_area_new(void);
SceneLight light_hemisphere_new(const double light[3], const double ground[3]);
#endif
