/* The method points of the thesis: ambient occlusion by sample points in the hemisphere. Its
 * GLSL is indirect_points.glsl; the view visibility traces single rays. */
#include "gen/render_text.h"
#include "runtime/indirect/settings/indirect_method.h"

const IndirectMethod indirect_points = {
    .word = KEYWORD_Indirect_points,
    .reads = INDIRECT_READS_voxels_by_march,
    .unlit = true,
    .steps = 8,
    .ray = render_text_voxel_march,
    .hit = render_text_indirect_march,
    .around = render_text_indirect_points,
};
