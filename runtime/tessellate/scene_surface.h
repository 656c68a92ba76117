/* Surfaces of objects on which copies are scattered: random points, uniformly distributed by
 * area. */
#ifndef MATC_SCENE_SURFACE_H
#define MATC_SCENE_SURFACE_H
#include "runtime/scene/scene.h"

enum {
    SCENE_SURFACE_TRIANGLES = 1 << 23 /* limit for all surfaces of a scene, each time one is made */
};

typedef struct {
    Shape shape; /* triangles in the object's own space */
    bool made;   /* made for this surface, which owns it; else the scene's */
    int first;   /* index of its first triangle among all */
    int object;  /* index among the objects that the surface was made of */
    SceneMatrix matrix;
    /* Vertices with the sum of all normals at their place, by the place's first vertex; NULL
     * before scene_surface_join(). */
    ShapeVertex *joined;
    int *place; /* indexed by vertex: the first vertex of its place */
} SceneSurfacePart;

typedef struct {
    SceneSurfacePart *patches;
    int patch_count;
    double *sums; /* prefix sums of the triangles' areas, inclusive */
    int count;    /* number of triangles */
} SceneSurface;

/* Makes the surface of `count` objects, in the space of their matrices; none may be a Plane.
 * False: out of memory, or too many triangles; nothing remains allocated. */
bool scene_surface_make(const Scene *scene, const SceneObject *objects, int count,
                        SceneSurface *made);
void scene_surface_free(SceneSurface *surface);
double scene_surface_area(const SceneSurface *surface);
/* Sets the point for three numbers in [0, 1), and the unit normal there, interpolated from the
 * corners. The surface must have an area. */
void scene_surface_point(const SceneSurface *surface, const double numbers[3], double point[3],
                         double normal[3]);
/* The point as vertices of its object, in that object's space: the point itself, and four around
 * it in the plane of its triangle, offset forward and backward along two edges. Returns the
 * index of the object in the surface. */
enum { SCENE_SURFACE_AROUND = 5 };
int scene_surface_around(const SceneSurface *surface, const double numbers[3],
                         ShapeVertex around[SCENE_SURFACE_AROUND]);
/* Computes the normals for rounding hard-edged meshes. False: out of memory. */
bool scene_surface_join(SceneSurface *surface);
/* Sets the displacement of each of these points by `push` and `bulge`, as displace_point.glsl
 * rounds a hard-edged mesh, in its object's space. Requires scene_surface_join(). */
void scene_surface_rounded(const SceneSurface *surface, const double numbers[3],
                           const SceneDividing *by, double to[SCENE_SURFACE_AROUND][3]);
#endif
