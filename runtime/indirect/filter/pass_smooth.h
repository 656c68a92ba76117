/* Temporal accumulation, denoiser and upsampling of the rays' results. */
#ifndef MATC_INDIRECT_PASS_SMOOTH_H
#define MATC_INDIRECT_PASS_SMOOTH_H
#include "runtime/frame_graph/frame_pass.h"

/* Returns the denoiser's radius in pixels of the picture. */
int pass_smooth_reach(const Renderer *renderer);
/* The rows of the frame graph. */
extern const FramePass pass_temporal, pass_smooth, pass_spread;
#endif
