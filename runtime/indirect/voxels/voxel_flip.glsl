// A triangle of a closed mesh: turns over all voxels of its column whose middles lie behind it.
// Voxels flipped twice are as before, so that those inside stay full. VOXEL_LAYERS: of 128
// voxels each, one above the other.
layout(location = 0) out uvec4 voxels[VOXEL_LAYERS];

void main()
{
    int first = int(floor(gl_FragCoord.z * float(VOXEL_SIZE) + 0.5));
    for (int layer = 0; layer < VOXEL_LAYERS; layer++) {
        ivec4 begin = ivec4(first) - (ivec4(0, 32, 64, 96) + 128 * layer); // of the word
        uvec4 within = uvec4(0xFFFFFFFFu) << uvec4(clamp(begin, 0, 31));
        voxels[layer] = mix(within, uvec4(0u), greaterThanEqual(begin, ivec4(32)));
    }
}
