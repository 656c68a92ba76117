// A triangle of a closed mesh: flips all voxels of its column whose centers lie behind it. Voxels
// flipped an even number of times are outside. VOXEL_LAYERS: number of layers of 128 voxels.
layout(location = 0) out uvec4 voxels[VOXEL_LAYERS];

void main()
{
    int first = int(floor(gl_FragCoord.z * float(VOXEL_SIZE) + 0.5));
    for (int layer = 0; layer < VOXEL_LAYERS; layer++) {
        // first bit to flip in each component
        ivec4 begin = ivec4(first) - (ivec4(0, 32, 64, 96) + 128 * layer);
        uvec4 within = uvec4(0xFFFFFFFFu) << uvec4(clamp(begin, 0, 31));
        voxels[layer] = mix(within, uvec4(0u), greaterThanEqual(begin, ivec4(32)));
    }
}
