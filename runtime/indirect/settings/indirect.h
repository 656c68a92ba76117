/* Indirect light: settings, resolved from the scene and the driver, and state of temporal
 * accumulation. docs/design/indirect.md explains the passes. */
#ifndef MATC_INDIRECT_INDIRECT_H
#define MATC_INDIRECT_INDIRECT_H
#include "runtime/indirect/settings/indirect_state.h"
#include "runtime/frame_graph/renderer_options.h"

/* -- Settings */

/* Reports whether the scene has indirect light. */
bool indirect_is(const Renderer *renderer);
/* Returns the method in use; NULL if the scene has no `indirect:` block. */
const IndirectMethod *indirect_method(const Renderer *renderer);
/* Returns the components of a view of ambient occlusion or indirect light; 0 for any other view. */
int indirect_view_components(const char *view);
/* Reports whether the view has that name. */
bool indirect_shows(const Renderer *renderer, const char *view);
/* Returns the reason why the scene has nothing to show in a view of indirect light; NULL if the
 * view can be shown. */
const char *indirect_missing_view(const Renderer *renderer);
/* Reports whether light bounces more than once by screen-space rays, each bounce by a run of the
 * passes. */
bool indirect_is_repeated(const Renderer *renderer);
/* Reports whether the rays' result is denoised, upsampled, accumulated, or the input of a
 * further bounce. */
bool indirect_is_smoothed(const Renderer *renderer);
/* Report whether rays are traced through voxels, and whether hits return cached radiance instead
 * of light on screen. */
bool indirect_reads_voxels(const Renderer *renderer);
bool indirect_reads_radiance(const Renderer *renderer);
/* Returns the resolution divisor of the ray pass per axis: 1, 2 or 4. */
int indirect_coarse(const Renderer *renderer);
/* Returns the resolution divisor for frames in which something moves; 0: not larger than the
 * usual one. */
int indirect_moving(const Renderer *renderer);
/* Reports whether this frame uses the resolution divisor for motion. */
bool indirect_moves(const Renderer *renderer);

/* -- Temporal accumulation */

/* Accumulated samples that may be out of date: light from other surfaces, or ambient occlusion. */
typedef enum { INDIRECT_DIRTY_light = 1, INDIRECT_DIRTY_ao = 2 } IndirectDirty;

/* Reports whether results of several frames, or of several sets of rays, are averaged. */
bool indirect_keeps(const Renderer *renderer);
/* Returns the max number of sets of rays that are averaged. */
int indirect_most_sets(const Renderer *renderer);
/* Reports whether enough sets are averaged, so that no further rays are traced. */
bool indirect_is_done(const Renderer *renderer);
/* Returns the texture of the means. */
GLuint indirect_kept(const Renderer *renderer);
/* Rejects all accumulated samples. If frames accumulate, keeps those that reproject onto the
 * same surface. */
void indirect_forget(Renderer *renderer);
/* Lowers the weight of accumulated samples, more so near moved objects; `dirty` is a set of
 * IndirectDirty. */
void indirect_invalidate(Renderer *renderer, unsigned dirty);
/* Frees the resources of FrameIndirect. */
void indirect_delete(Renderer *renderer);
#endif
