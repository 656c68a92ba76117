/* The triangles of all that is opaque, or transparent by the same everywhere, as shadows: exact
 * take them: every object's one behind the other, in floats, once rounded. No GL. */
#ifndef MATC_RENDER_EXACT_TRIANGLES_H
#define MATC_RENDER_EXACT_TRIANGLES_H
#include "runtime/cache/cache.h"

/* In the world. */
typedef struct {
    double low[3], high[3];
} ExactBox;

typedef struct {
    int object;       /* in Scene.objects */
    int first, count; /* of its triangles */
    ExactBox box;     /* around them */
} ExactObject;

typedef struct {
    double origin
        /* what corners are counted from, in the world: near the middle of them all, on a grid, so
         * that it rarely moves */
        [3];
    double reach; /* the greatest coordinate from there, whatever its sign */
    int count;
    ExactObject *objects; /* in the order of cache->places: opaque ones first */
    int object_count, opaque_count;
} ExactTriangles;

/* Along the world's axes; where two triangles meet, bit for bit the same. The fourth lanes are what
 * the triangle lets through: red, green, blue. */
typedef float ExactCorners[3][4];

/* The place's object is one of them. */
bool exact_triangles_have(const CachePlace *place);
/* Measures all objects. False: memory ran out, or there are more triangles than an int counts;
 * *made is empty then. */
bool exact_triangles_make(const Scene *scene, const Cache *cache, ExactTriangles *made);
/* Measures some of its objects again, which stand elsewhere. False: memory ran out. */
bool exact_triangles_move(const Scene *scene, const Cache *cache, const int range[2],
                          ExactTriangles *triangles);
/* Corners of its objects range[0] to range[1] - 1, from the first one's on. False: memory ran
 * out. */
bool exact_triangles_corners(const Scene *scene, const Cache *cache,
                             const ExactTriangles *triangles, const int range[2],
                             ExactCorners *corners);
/* Safe on an empty one. */
void exact_triangles_free(ExactTriangles *triangles);
#endif
