/* Ray-marched displacement (displaced_traced.h) in two steps: the rays of all such surfaces find
 * hits and depth; then the material's own program runs for the pixels that the surface covers. */
#ifndef MATC_CACHE_CACHE_TRACE_H
#define MATC_CACHE_CACHE_TRACE_H
#include "runtime/cache/cache.h"

/* Makes the programs of kinds with ray-marched surfaces: opaque ones, unless triangle ids or
 * lines are drawn. */
bool cache_trace_make(Store *store, const CacheSource *source, Cache *cache);
void cache_trace_delete(Cache *cache);
/* Applies a new view. */
void cache_trace_view(const CacheSource *source, Cache *cache);
/* Reports whether the drawable is ray-marched. */
bool cache_traces(const Cache *cache, const Drawable *drawable);
/* Writes depth, and the hit to the color target (RGBA32UI, 0 for background). */
void cache_trace_rays(GlContext *gl, const CacheSource *source, Cache *cache);
/* Writes the G-buffer of the hits in the texture `met`, without a depth test. */
void cache_trace_surfaces(GlContext *gl, const CacheSource *source, Cache *cache, GLuint met);

/* Instances of a mesh in a shadow map: a range of Cache.list. */
typedef struct {
    const CacheLight *light;
    int first, count;
} CacheTraceCast;
void cache_trace_cast(GlContext *gl, Cache *cache, int mesh, const CacheTraceCast *cast);
#endif
