/* Documents by which several shadow methods are tested: touching objects in the light of every
 * kind of lamp; and a scene of several lights with a glass object. */
#ifndef MATC_SHADOW_SCENE_H
#define MATC_SHADOW_SCENE_H
#include "tests/frame/frame_draw.h"

/* A picture of any size, from the front and above, with the material m. */
#define SHADOW_SCENE_VIEW                                                                          \
    "camera: { camera: Perspective, position: [1.5, -7, 4], target: [0, 0, .5], angle: 42 }\n"     \
    "materials: { m: { material: Phong, diffuse: .5 } }\n"
/* The ground below all other objects: the first object. */
#define SHADOW_SCENE_GROUND                                                                        \
    "objects:\n- { object: Parallelogram, u: [8, 0, 0], v: [0, 8, 0], material: m, transform: { "  \
    "translation: [-4, "                                                                           \
    "-4, 0] } }\n"
#define SHADOW_SCENE_PLANE "objects:\n- { object: Plane, material: m }\n"
/* Touching meshes: all stand on the ground, a box touches another box, a cone a cylinder.
 * `detail` is the ball's, as in "detail: 48, ". */
#define SHADOW_SCENE_OBJECTS(detail)                                                               \
    "- { object: Sphere, radius: .8, " detail                                                      \
    "material: m, transform: { translation: [-.6, -.4, .8] } }\n"                                  \
    "- { object: Box, material: m, transform: { translation: [1, .5, .5], rotation: [0, 0, .3] } " \
    "}\n"                                                                                          \
    "- { object: Box, size: [.5, .5, .5], material: m, transform: { translation: [1.1, .5, 1.25] " \
    "} }\n"                                                                                        \
    "- { object: Cylinder, radius: .3, height: .8, material: m, transform: { translation: [.6, "   \
    "-1.4, 0] } }\n"                                                                               \
    "- { object: Cone, radius: .3, height: .6, material: m, transform: { translation: [.6, -1.4, " \
    ".8] } }\n"                                                                                    \
    "- { object: Parallelogram, u: [0, 1.6, 0], v: [.4, 0, 1], material: m, transform: { "         \
    "translation: [-2.2, -.6, 0] "                                                                 \
    "} }\n"

/* -- a scene in the light of one lamp */

typedef struct {
    const char *kind; /* kind of the lamp, and further parameters */
    bool placed, directed;
    double distance; /* distance from the origin */
} ShadowLamp;
enum { SHADOW_LAMPS = 5 };
extern const ShadowLamp shadow_lamps[SHADOW_LAMPS];

typedef struct {
    /* image and other settings, before the view; a method of the list Shadows */
    const char *head, *method;
    const ShadowLamp *lamp;
    const double *angle;    /* an entry of shadow_angles */
    const char *objects[2]; /* the ground, and the objects on it */
} ShadowScene;

Scene *shadow_scene(const ShadowScene *from, const MatcOptions *options, MatcDocument **document);

/* -- a scene of all at once: 64 x 48 pixels, two lights by a method, one by maps, a plane, a pane
 * over it */

/* `head` comes first; `more`: further lights, each after a comma; `through`, a number, is the
 * pane's transmittance. */
#define SHADOW_SCENE_MIXED(head, method, more, detail)                                             \
    head                                                                                           \
        "image: { width: 64, height: 48 }\n"                                                       \
        "camera: { camera: Perspective, position: [1.5, -7, 4], target: [0, 0, .5], angle: 42 }\n" \
        "materials: { m: { material: Phong, diffuse: .5 }, g: { material: Phong, diffuse: 0, "     \
        "transparency: %s, "                                                                       \
        "interpolatedTransparency: false } }\n"                                                    \
        "lights: [{ light: Directional, direction: [1, 1, -2], shadows: " method " },\n"           \
        "  { light: Point, position: [1, -2, 4], intensity: 9, shadows: " method " },\n"           \
        "  { light: Point, position: [-2, -2, 3], intensity: 4, shadows: map }" more               \
        "]\n" SHADOW_SCENE_PLANE                                                                   \
        SHADOW_SCENE_OBJECTS(                                                                      \
            detail) "- { object: Parallelogram, u: [1, 0, 0], v: [0, 1, 0], material: g, "         \
                    "transform: { translation: [-.4, -1.6, 1.3] } }\n"

Scene *shadow_scene_mixed(const char *mixed, const char *through, const MatcOptions *options,
                          MatcDocument **document);
/* Checks the first light: in the pane's shadow one half, and a quarter where the shadow is seen
 * through the pane. */
void shadow_scene_assert_glass(GlContext *gl, const char *mixed);
/* Checks that OpenGL 3.3 refuses the scene with a message. */
void shadow_scene_assert_refused(GlContext *gl, const char *mixed, const char *message);
#endif
