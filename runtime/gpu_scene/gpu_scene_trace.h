/* Ray-marched displacement (displaced_traced.h) in two steps: the rays of all such surfaces find
 * hits and depth; then the material's own program runs for the pixels that the surface covers. */
#ifndef MATC_GPU_SCENE_GPU_SCENE_TRACE_H
#define MATC_GPU_SCENE_GPU_SCENE_TRACE_H
#include "runtime/gpu_scene/gpu_scene.h"

/* Makes the programs of kinds with ray-marched surfaces: opaque ones, unless triangle ids or
 * lines are drawn. */
bool gpu_scene_trace_make(Store *store, const GpuSceneSource *source, GpuScene *gpu_scene);
void gpu_scene_trace_delete(GpuScene *gpu_scene);
/* Applies a new view. */
void gpu_scene_trace_view(const GpuSceneSource *source, GpuScene *gpu_scene);
/* Reports whether the drawable is ray-marched. */
bool gpu_scene_traces(const GpuScene *gpu_scene, const Drawable *drawable);
/* Writes depth, and the hit to the color target (RGBA32UI, 0 for background). */
void gpu_scene_trace_rays(GlContext *gl, const GpuSceneSource *source, GpuScene *gpu_scene);
/* Writes the G-buffer of the hits in the texture `met`, without a depth test. */
void gpu_scene_trace_surfaces(GlContext *gl, const GpuSceneSource *source, GpuScene *gpu_scene,
                              GLuint met);

/* Instances of a mesh in a shadow map: a range of GpuScene.list. */
typedef struct {
    const GpuSceneLight *light;
    int first, count;
} GpuSceneTraceCast;
void gpu_scene_trace_cast(GlContext *gl, GpuScene *gpu_scene, int mesh,
                          const GpuSceneTraceCast *cast);
#endif
