/* A renderer and the states of all folders of passes, in the one block that renderer_open
 * allocates. */
#ifndef MATC_RENDERER_RENDERER_STATE_H
#define MATC_RENDERER_RENDERER_STATE_H
#include "runtime/transparency/transparency_state.h"
#include "runtime/indirect/settings/indirect_state.h"
#include "runtime/indirect/screen/pass_positions.h"
#include "runtime/indirect/radiance/radiance.h"
#include "runtime/indirect/voxels/voxels.h"
#include "runtime/light/light_state.h"
#include "runtime/post/post_state.h"
#include "runtime/shadow/shadow_state.h"

typedef struct {
    Renderer renderer;
    FrameLight light;
    ShadowMaps shadows;
    FrameVoxels voxels;
    FrameRadiance radiance;
    FrameIndirect indirect;
    FramePositions positions;
    FramePost post;
    FrameTransparency transparent;
} RendererState;
#endif
