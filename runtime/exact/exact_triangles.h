/* Triangles of all shadow casters for exact shadows, opaque or of constant transparency: one
 * object's after the other, as floats, rounded once. No GL. */
#ifndef MATC_RENDER_EXACT_TRIANGLES_H
#define MATC_RENDER_EXACT_TRIANGLES_H
#include "runtime/gpu_scene/gpu_scene.h"

/* A bounding box in world space. */
typedef struct {
    double low[3], high[3];
} ExactBox;

typedef struct {
    int object;       /* index in Scene.objects */
    int first, count; /* range of the object's triangles */
    ExactBox box;     /* bounding box */
} ExactObject;

typedef struct {
    /* World position to which corners are relative: near the center of all objects, on a
     * grid, so that it rarely changes. */
    double origin[3];
    double reach; /* the greatest absolute coordinate relative to the origin */
    int count;
    ExactObject *objects; /* objects in the order of GpuScene.places: opaque ones first */
    int object_count, opaque_count;
} ExactTriangles;

/* Corners along the world's axes; identical, bit for bit, where triangles share a corner. The
 * fourth components are the triangle's transmittance: red, green, blue. */
typedef float ExactCorners[3][4];

/* Returns whether the place's object has triangles for exact shadows. */
bool exact_triangles_have(const GpuScenePlace *place);
/* Measures all objects. False: out of memory, or more triangles than an int can count; *made is
 * empty then. */
bool exact_triangles_make(const Scene *scene, const GpuScene *gpu_scene, ExactTriangles *made);
/* Measures objects range[0] to range[1] - 1 again after they moved. False: out of memory. */
bool exact_triangles_move(const Scene *scene, const GpuScene *gpu_scene, const int range[2],
                          ExactTriangles *triangles);
/* Writes the corners of objects range[0] to range[1] - 1, beginning with the first one's. False:
 * out of memory. */
bool exact_triangles_corners(const Scene *scene, const GpuScene *gpu_scene,
                             const ExactTriangles *triangles, const int range[2],
                             ExactCorners *corners);
/* Frees the triangles; also valid for a zeroed struct. */
void exact_triangles_free(ExactTriangles *triangles);
#endif
