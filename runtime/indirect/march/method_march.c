/* The method march of the thesis: ray marching by even steps through the depth buffer, or
 * through voxels. */
#include "gen/render_text.h"
#include "runtime/indirect/settings/indirect_method.h"

const IndirectMethod indirect_march = {
    .word = KEYWORD_Indirect_march,
    .reads = INDIRECT_READS_voxels_by_march,
    .steps = 8,
    .ray = render_text_voxel_march,
    .hit = render_text_indirect_march,
};
