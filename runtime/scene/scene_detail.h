/* Detail of bodies by their size in the picture.
 *
 * A scene of at most SCENE_FINE_TRIANGLES keeps all that its documents say. In a larger one a
 * Sphere, Cylinder or Cone without a `detail` of its own has as many sides as the picture shows,
 * and a displaced object as many triangles: a few levels, each half as fine along an edge as the
 * one before, so that copies of one level share a mesh.
 *
 *     A cylinder of radius 1, a camera of 500 pixels at a distance of 1 whose picture reaches 30
 *         degrees to each side, 100 away:
 *     a unit has 500 / 99 / cos^2 30 = 6.7 pixels; 24 sides are off by 6.7 (1 - cos(pi / 24)) =
 *         0.06 of them, 12 by 0.23: it has 24 */
#ifndef MATC_SCENE_DETAIL_H
#define MATC_SCENE_DETAIL_H
#include "runtime/scene/scene.h"

enum {
    /* that all objects of a scene together may have without a thought of the picture */
    SCENE_FINE_TRIANGLES = 1 << 19,
    SCENE_HEAVY_TRIANGLES = 5000000, /* beyond these there is a warning */
    SCENE_DETAIL_STEPS = 192,        /* of the finest level, the default of `detail` */
    SCENE_DETAIL_LEVELS = 5,         /* 192, 96, 48, 24 and 12 steps */
    SCENE_DETAIL_EYES = 32           /* balls that hold the camera's path */
};
#define SCENE_DETAIL_ERROR .125 /* pixels by which the outline of a coarser body may be off */
#define SCENE_DETAIL_EDGE  2.   /* pixels of an edge of a displaced triangle, at most on average */

/* A ball that holds where the camera is during a part of its motion. */
typedef struct {
    double center[3], radius;
} SceneDetailEye;

/* From where a scene is seen. All zero: every body is as fine as it can be. */
typedef struct {
    const Scene *scene;
    SceneDetailEye eyes[SCENE_DETAIL_EYES];
    int eye_count;
    /* of a length at a distance of that length, anywhere in the picture; orthographic: of a unit */
    double pixels;
} SceneDetail;

/* The scene's own camera, or all of its motion, in a picture of so many pixels. */
void scene_detail_find(const Scene *scene, const int size[2], SceneDetail *detail);
/* The steps of the coarsest level whose outline is right, of a radius of so many pixels. */
int scene_detail_steps(SceneKind kind, double pixels);
/* Where a body with steps has them among its numbers; it is one of those whose detail goes by the
 * picture. */
static inline int scene_detail_number(SceneKind kind) { return kind == SCENE_Sphere ? 1 : 2; }
/* A ball around an object in its own space. */
typedef struct {
    double center[3], radius;
} SceneBall;
/* `shape` is that of a Mesh. */
SceneBall scene_detail_ball(const SceneObject *object, const Shape *shape);
/* By how much a matrix stretches at most; exact where its columns are at right angles. */
double scene_detail_stretch(const SceneMatrix *matrix);
/* Pixels of a unit of the world at an object, at most. `reach`: no point of it is moved farther. */
double scene_detail_unit(const SceneDetail *detail, const SceneMatrix *world_from_local,
                         const SceneBall *ball, double reach);
#endif
