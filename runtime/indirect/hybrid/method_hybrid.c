/* The methods hybrid and voxels: rays through voxels, whose hits return cached radiance. Hybrid
 * first tests the depth buffer along a ray's first voxels. */
#include "gen/render_text.h"
#include "runtime/indirect/settings/indirect_method.h"

const IndirectMethod indirect_hybrid = {
    .word = KEYWORD_Indirect_hybrid,
    .automatic = true,
    .reads = INDIRECT_READS_voxels | INDIRECT_READS_radiance | INDIRECT_READS_near,
    .steps = 4, /* one step for each voxel */
    .ray = render_text_voxel_ray,
    .hit = render_text_indirect_near,
};

const IndirectMethod indirect_voxels = {
    .word = KEYWORD_Indirect_voxels,
    .reads = INDIRECT_READS_voxels | INDIRECT_READS_radiance,
    .steps = 8,
    .ray = render_text_voxel_ray,
    .hit = render_text_indirect_near,
};
