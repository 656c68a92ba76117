/* Surfaces that are traced (displaced_traced.h), in two steps: rays of all of them say which is met
 * where, and how deep; the material's own program then runs for the pixels that it is met in. */
#ifndef MATC_CACHE_CACHE_TRACE_H
#define MATC_CACHE_CACHE_TRACE_H
#include "runtime/cache/cache.h"

/* Programs of the kinds whose surfaces are traced: opaque ones, where nothing asks which triangle a
 * pixel sees. */
bool cache_trace_make(Store *store, const CacheSource *source, Cache *cache);
void cache_trace_delete(Cache *cache);
/* The view is another. */
void cache_trace_view(const CacheSource *source, Cache *cache);
/* The drawable is traced. */
bool cache_traces(const Cache *cache, const Drawable *drawable);
/* Depth, and in the colour target (RGBA32UI, 0 where nothing is) what was met. */
void cache_trace_rays(GlContext *gl, const CacheSource *source, Cache *cache);
/* The G-buffer of what was met; nothing behind is asked for depth. */
void cache_trace_surfaces(GlContext *gl, const CacheSource *source, Cache *cache, GLuint met);

/* Instances of a mesh, in a shadow map: places of the list, from `first` on. */
typedef struct {
    const CacheLight *light;
    int first, count;
} CacheTraceCast;
void cache_trace_cast(GlContext *gl, Cache *cache, int mesh, const CacheTraceCast *cast);
#endif
