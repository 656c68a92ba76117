/* Indirect light: settings, resolved from the scene and the driver, and what is accumulated over
 * frames. docs/design/indirect.md explains the passes. */
#ifndef MATC_INDIRECT_INDIRECT_H
#define MATC_INDIRECT_INDIRECT_H
#include "runtime/indirect/settings/indirect_state.h"
#include "runtime/frame/render_options.h"

/* -- Settings */

/* The scene has indirect light. */
bool indirect_is(const Render *render);
/* The method in use; NULL if the scene says none. */
const IndirectMethod *indirect_method(const Render *render);
/* Components of a view of ambient occlusion or indirect light; 0 for any other view. */
int indirect_view_lanes(const char *view);
/* The view has that name. */
bool indirect_shows(const Render *render, const char *view);
/* Why the scene has nothing to show in the view; NULL if it has, or the view is another. */
const char *indirect_lacks_view(const Render *render);
/* Light bounces more than once by rays in screen space, each bounce by a run of the passes. */
bool indirect_is_repeated(const Render *render);
/* The result of the rays is denoised, upsampled, accumulated, or the input of a further bounce. */
bool indirect_is_smoothed(const Render *render);
/* Rays are traced through voxels; hits return cached radiance instead of what is on screen. */
bool indirect_reads_voxels(const Render *render);
bool indirect_reads_radiance(const Render *render);
/* Pixels of the picture along an edge of one from which rays go out: 1, 2 or 4. */
int indirect_coarse(const Render *render);
/* Resolution divisor while something moves, if it is larger; else 0. */
int indirect_moving(const Render *render);
/* This frame uses that. */
bool indirect_moves(const Render *render);

/* -- Temporal accumulation */

/* Samples that may be out of date: of light from other surfaces, of ambient occlusion. */
typedef enum { INDIRECT_DOUBT_light = 1, INDIRECT_DOUBT_openness = 2 } IndirectDoubt;

/* Results of several frames, or of several sets of rays, are averaged. */
bool indirect_keeps(const Render *render);
/* The number of sets of rays that are averaged at most. */
int indirect_most_sets(const Render *render);
/* No further rays are traced. */
bool indirect_is_done(const Render *render);
/* The texture of the means. */
GLuint indirect_kept(const Render *render);
/* Rejects all accumulated samples, or, if frames accumulate, those that do not reproject onto the
 * same surface. */
void indirect_forget(Render *render);
/* Lowers the weight of accumulated samples; `doubts` is a set of IndirectDoubt. Also near moved
 * objects they count less. */
void indirect_doubt(Render *render, unsigned doubts);
/* Frees what FrameIndirect holds. */
void indirect_delete(Render *render);
#endif
