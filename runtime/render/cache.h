/* A scene on the driver's side: each mesh once, and each object with its program, its buffer and its mesh, in the order of the programs. */
#ifndef MATC_RENDER_CACHE_H
#define MATC_RENDER_CACHE_H
#include "runtime/gl/mesh.h"
#include "runtime/render/set.h"
#include "runtime/render/view_space.h"

typedef struct {
    Material material; /* with the object's matrices */
    int mesh;          /* in Cache.meshes; -1 for a plane */
    bool mirrored;     /* its triangles turn the other way round */
    int object;        /* in Scene.objects */
} Drawable;

typedef struct {
    Mesh *meshes;
    int mesh_count;
    Drawable *surfaces, *planes; /* sorted by program, then mesh */
    int surface_count, plane_count;
    Material sky;
    bool has_sky;
    long triangles; /* of all surfaces */
} Cache;

typedef struct {
    const Scene *scene;
    const Set *set;
    const ViewSpace *space;
} CacheSource;

/* False: see the context's error; *made is empty then. */
bool cache_make(Store *store, const CacheSource *source, Cache *made);
/* Safe on an empty one, which it leaves behind. */
void cache_delete(GlContext *gl, Cache *cache);
#endif
