// A level of the slice map from the one below: 2 x 2 columns are one, and its voxels as long as
// ever.
uniform usampler2DArray voxel_below; // whose level is the only one that is read
layout(location = 0) out uvec4 voxels[VOXEL_LAYERS];

void main()
{
    ivec2 at = 2 * ivec2(gl_FragCoord.xy);
    for (int layer = 0; layer < VOXEL_LAYERS; layer++)
        voxels[layer] = texelFetch(voxel_below, ivec3(at, layer), 0) | texelFetch(voxel_below, ivec3(at + ivec2(1, 0), layer), 0) |
                        texelFetch(voxel_below, ivec3(at + ivec2(0, 1), layer), 0) | texelFetch(voxel_below, ivec3(at + ivec2(1, 1), layer), 0);
}
