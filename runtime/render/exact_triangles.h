/* The triangles of all that is opaque, as shadows: exact take them: every object's in one array, in floats, once rounded. No GL. */
#ifndef MATC_RENDER_EXACT_TRIANGLES_H
#define MATC_RENDER_EXACT_TRIANGLES_H
#include "runtime/render/cache.h"

typedef struct {
    double origin[3];       /* what corners are counted from, in the world: the middle of them all */
    float (*corners)[3][3]; /* of each triangle, along the world's axes; where two meet, bit for bit the same */
    int count;
    double reach; /* the greatest coordinate, whatever its sign */
} ExactTriangles;

/* Triangles in the order of cache->places. False: memory ran out, or there are more than an int counts; *made is empty then. */
bool exact_triangles_make(const Scene *scene, const Cache *cache, ExactTriangles *made);
/* Safe on an empty one. */
void exact_triangles_free(ExactTriangles *triangles);
#endif
