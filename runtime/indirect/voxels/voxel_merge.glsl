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
        for (int component = 0; component < 4 && 4 * layer + component < words; component++)
            voxels[layer][component] |= texelFetch(voxel_surface, ivec3(at, 4 * layer + component),
                0).x;
    }
}
