/* Level of detail of solids by their size in the picture.
 *
 * A scene of at most SCENE_FINE_TRIANGLES has the detail of its documents. In a larger one a
 * Sphere, Cylinder or Cone without a `detail` of its own has as many sides as the picture
 * resolves, and a displaced object as many triangles: there are a few levels, each half as fine
 * along an edge as the previous one, so that copies of one level share a mesh.
 *
 *     A cylinder of radius 1, a camera of 500 pixels at a distance of 1 whose picture reaches 30
 *         degrees to each side, 100 away: a unit has 500 / 99 / cos^2 30 = 6.7 pixels. 24 sides
 *         have an error of 6.7 (1 - cos(pi / 24)) = 0.06 pixels, 12 sides of 0.23: the cylinder
 *         has 24 sides. */
#ifndef MATC_SCENE_DETAIL_H
#define MATC_SCENE_DETAIL_H
#include "runtime/scene/scene.h"

enum {
    /* max triangles of a scene that keeps full detail */
    SCENE_FINE_TRIANGLES = 1 << 19,
    SCENE_HEAVY_TRIANGLES = 5000000, /* number of triangles above which a warning is reported */
    SCENE_DETAIL_STEPS = 192,        /* steps of the finest level, the default of `detail` */
    SCENE_DETAIL_LEVELS = 5,         /* number of levels: 192, 96, 48, 24 and 12 steps */
    SCENE_DETAIL_EYES = 32           /* max bounding spheres of the camera's path */
};
#define SCENE_DETAIL_ERROR .125 /* max error of a coarser solid's silhouette, in pixels */
#define SCENE_DETAIL_EDGE  2.   /* max mean edge of displaced triangles, in pixels */

/* A bounding sphere of the camera's positions during a part of its motion. */
typedef struct {
    double center[3], radius;
} SceneDetailEye;

/* Views of a scene, for levels of detail. All zero: full detail. */
typedef struct {
    const Scene *scene;
    SceneDetailEye eyes[SCENE_DETAIL_EYES];
    int eye_count;
    /* Max pixels of a length at a distance equal to it, anywhere in the picture; orthographic:
     * of a unit. */
    double pixels;
} SceneDetail;

/* Finds the views of the scene's camera, or of its whole motion, in a picture of `size` pixels. */
void scene_detail_find(const Scene *scene, const int size[2], SceneDetail *detail);
/* Returns the steps of the coarsest level whose silhouette is accurate enough, for a radius in
 * pixels. */
int scene_detail_steps(SceneKind kind, double pixels);
/* Returns the index of a solid's steps in SceneObject.numbers; the solid must be a Sphere,
 * Cylinder or Cone. */
static inline int scene_detail_number(SceneKind kind) { return kind == SCENE_Sphere ? 1 : 2; }
/* A bounding sphere of an object in local space. */
typedef struct {
    double center[3], radius;
} SceneBall;
/* Returns the bounding sphere; `shape` is that of a Mesh. */
SceneBall scene_detail_ball(const SceneObject *object, const Shape *shape);
/* Returns an upper bound of the scale of a matrix; exact for orthogonal columns. */
double scene_detail_stretch(const SceneMatrix *matrix);
/* Returns the max pixels of a world unit at an object. `reach`: max displacement of its points. */
double scene_detail_unit(const SceneDetail *detail, const SceneMatrix *world_from_local,
                         const SceneBall *ball, double reach);
#endif
