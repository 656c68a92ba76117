/* Kinds of lights. A light is data, SceneLight. Its kind is a row, LightKind, which defines the
 * origin of its light, reads its own parameters, and has its GLSL. Only the files of a kind and
 * the list light_kinds.def name a kind; all other code uses the row. docs/design/add-a-light.md
 * explains how to add a kind.
 *
 * Lengths are in the world's units and axes, positions relative to Scene.origin. */
#ifndef MATC_LIGHT_KIND_H
#define MATC_LIGHT_KIND_H
#include "compiler/base/diag.h"
#include "grammar/scene_tables.h"

typedef struct {
    SceneKind kind; /* a kind of the sort light */
    double position[3];
    double direction[3];               /* direction of emission; unit length */
    double light[3];                   /* emitted color: intensity times color */
    double ground[3];                  /* emitted color of a hemisphere light from below */
    double inner_cosine, outer_cosine; /* cosines of a spot's cone angles: inner >= outer */
    double edges[2][3];                /* edge vectors of an area light */
    bool both_sides;                   /* an area light also emits to the back */
    const char *name;                  /* the light's name; NULL: unnamed */
    /* The technique of the shadows that the light causes: KEYWORD_Shadows_none, ... */
    Keyword shadows;
} SceneLight;

/* Origin of the light, which determines its shadow views: a point has those of a cube or a cone,
 * distant light has parallel views, an area light has a view for each of several points. */
typedef enum {
    LIGHT_FROM_point, /* light from its position */
    LIGHT_FROM_afar,  /* parallel light along its direction */
    /* light from a parallelogram: position + s edges[0] + t edges[1], s and t from 0 to 1 */
    LIGHT_FROM_extent,
    /* light from all directions, without shadows; all lights of the kind are summed */
    LIGHT_FROM_around,
    LIGHT_FROM_sky /* light from the scene's sky: no SceneLight, scales Scene.sky_light */
} LightFrom;

/* The numbers that a document gives a light, or their defaults, by their indices in the kind's
 * part of scene_param_table. */
typedef struct {
    SceneKind kind;
    double at[SCENE_KIND_PARAMS][3];
} LightParams;

/* An invalid parameter value. `text` is quoted in the message; NULL: nothing is quoted. */
typedef struct {
    DiagKind diag;
    int param;
    const char *text;
} LightFault;

/* Receives the lines that show a light as a gizmo. */
typedef struct LightLines {
    void (*add)(struct LightLines *lines, const double from[3], const double to[3]);
    double size;    /* length of a cross's lines, a cone's edges, a quarter of an arrow */
    double zero[3]; /* the world's origin, where a directional light is drawn */
} LightLines;

/* The GLSL of a kind is included twice: before the surface models, and after lighting.glsl with
 * LIGHT_SENDS defined. The second time it defines, by the name of the kind,
 *
 *     vec3 lightFromArea(int light, Seen seen)   reflected light of a light with a position
 *     vec3 lightFromAmbient(Seen seen)           or of all lights of the kind from around
 *
 * and reads a light's numbers by lightTexel() (light.layout.def). A kind from around has a
 * uniform block of the kind's name: up, the light from above and that from below, as three vec4. */
typedef struct {
    SceneKind kind;
    LightFrom from;
    /* Set for a kind from around whose radiance depends on the direction: the GLSL defines,
     * without LIGHT_SENDS, vec3 lightAlongHemisphere(vec3 direction). */
    bool varies;
    /* NULL: the formula for points and parallel light in lighting.glsl, which includes a cone. */
    const char *glsl;
    /* Reads parameters other than position, direction, color, intensity, shadows and name, which
     * all kinds share. False: invalid, see `fault`. NULL: no own parameters. */
    bool (*read)(const LightParams *params, SceneLight *light, LightFault *fault);
    /* Light within a cone: factor s s (3 - 2 s), s = clamp(scale cosine + shift, 0, 1) of the
     * angle from the direction. NULL: no cone, the light is the same in all directions. */
    void (*cone)(const SceneLight *light, double scale_shift[2]);
    /* Draws the light as a gizmo. NULL: the light has no gizmo. */
    void (*outline)(const SceneLight *light, LightLines *lines);
} LightKind;

/* The rows of light_kinds.def, followed by NULL. */
enum { LIGHT_KINDS_MAX = 16 };
extern const LightKind *const light_kind_table[LIGHT_KINDS_MAX + 1];

/* Return the index of a light's kind in the table, and its row. */
int light_kind_number(SceneKind kind);
const LightKind *light_kind_of(const SceneLight *light);
const char *light_kind_name(const LightKind *row);
static inline LightFrom light_from(const SceneLight *light) { return light_kind_of(light)->from; }

/* Returns the three numbers of a parameter; a scalar parameter has only the first. */
const double *light_params_at(const LightParams *params, int param);

/* Cosine of the half angle from which on a cone has the shadow views of a point light: a cube
 * map has finer texels than one wide view. */
#define LIGHT_KIND_WIDEST 0.5
/* Returns true for a point light, or a cone at least that wide. */
bool light_kind_is_wide(const SceneLight *light);

/* Sets the point at a distance from the light, at the angle angles[0] from its direction and
 * angles[1] around it. */
void light_kind_around(const SceneLight *light, const double angles[2], double distance,
                       double out[3]);

/* Make lights without shadows for the renderer itself; the caller sets their other properties. */
SceneLight light_directional_new(const double direction[3], const double light[3]);
SceneLight light_area_new(void);
SceneLight light_hemisphere_new(const double light[3], const double ground[3]);
#endif
