/* Temporal accumulation, denoiser and upsampling of the rays' results. */
#ifndef MATC_INDIRECT_PASS_DENOISE_H
#define MATC_INDIRECT_PASS_DENOISE_H
#include "runtime/frame_graph/frame_pass.h"

/* Returns the denoiser's radius in pixels of the picture. */
int pass_denoise_reach(const Renderer *renderer);
/* The rows of the frame graph. */
extern const FramePass pass_temporal, pass_denoise, pass_upsample;
#endif
