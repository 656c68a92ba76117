// A coarser level of the slice map: 2 x 2 columns become one; voxels keep their length along z.
uniform usampler2DArray voxel_below; // map of which the finer level is selected as base level
layout(location = 0) out uvec4 voxels[VOXEL_LAYERS];

void main()
{
    ivec2 at = 2 * ivec2(gl_FragCoord.xy);
    for (int layer = 0; layer < VOXEL_LAYERS; layer++)
        voxels[layer] = texelFetch(voxel_below, ivec3(at, layer), 0) | texelFetch(voxel_below,
            ivec3(at + ivec2(1, 0), layer), 0) |
                        texelFetch(voxel_below, ivec3(at + ivec2(0, 1), layer),
                            0) | texelFetch(voxel_below, ivec3(at + ivec2(1, 1), layer), 0);
}
