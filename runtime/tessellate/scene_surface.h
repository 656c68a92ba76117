/* The surface of objects, as that on which copies stand: points at random, evenly by area. */
#ifndef MATC_SCENE_SURFACE_H
#define MATC_SCENE_SURFACE_H
#include "runtime/scene/scene.h"

enum {
    SCENE_SURFACE_TRIANGLES = 1 << 23 /* of all surfaces of a scene, each time that one is made */
};

typedef struct {
    Shape shape; /* in its own space */
    bool made;   /* for the surface, with which it goes; else the scene's */
    int first;   /* of its triangles, among all */
    int object;  /* that it is of, among those that the surface was made of */
    SceneMatrix matrix;
    /* by the first vertex of a place: with the sum of all normals there; NULL before
     * scene_surface_join() */
    ShapeVertex *joined;
    int *place; /* by vertex: that one */
} SceneSurfacePart;

typedef struct {
    SceneSurfacePart *patches;
    int patch_count;
    double *sums; /* of the areas of all triangles up to one, that one included */
    int count;    /* of triangles */
} SceneSurface;

/* Makes the surface of that many objects, in the space that their matrices lead to; none is a
 * Plane. False: memory ran out, and nothing is made. */
bool scene_surface_make(const Scene *scene, const SceneObject *objects, int count,
                        SceneSurface *made);
void scene_surface_free(SceneSurface *surface);
double scene_surface_area(const SceneSurface *surface);
/* The point of three numbers in [0, 1), and the unit normal there, mixed of the corners'. The
 * surface has an area. */
void scene_surface_point(const SceneSurface *surface, const double numbers[3], double point[3],
                         double normal[3]);
/* The point as vertices of its object, in that object's space: itself, and four around it in the
 * plane of its triangle, before and behind it by a part of each of two edges. Returns the number of
 * the object in the surface. */
enum { SCENE_SURFACE_AROUND = 5 };
int scene_surface_around(const SceneSurface *surface, const double numbers[3],
                         ShapeVertex around[SCENE_SURFACE_AROUND]);
/* Finds what rounds hard bodies. False: memory ran out. */
bool scene_surface_join(SceneSurface *surface);
/* How far each of these points goes by `push` and `bulge`, as displace_point.glsl rounds a hard
 * body, in its object's space. After scene_surface_join(). */
void scene_surface_rounded(const SceneSurface *surface, const double numbers[3],
                           const SceneDividing *by, double to[SCENE_SURFACE_AROUND][3]);
#endif
