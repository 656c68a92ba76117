// Finest level of the slice map: union of the interiors of closed meshes and of other meshes'
// surfaces.
uniform usampler2DArray voxel_within, voxel_surface;
layout(location = 0) out uvec4 voxels[VOXEL_LAYERS];

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    int words = textureSize(voxel_surface, 0).z;
    for (int layer = 0; layer < VOXEL_LAYERS; layer++) {
        voxels[layer] = texelFetch(voxel_within, ivec3(at, layer), 0);
        for (int lane = 0; lane < 4 && 4 * layer + lane < words; lane++)
            voxels[layer][lane] |= texelFetch(voxel_surface, ivec3(at, 4 * layer + lane), 0).x;
    }
}
