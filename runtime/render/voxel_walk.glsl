// Walks through the slice map along a ray, voxel by voxel. Places are in voxels, from the map's lowest corner.
uniform usampler2DArray voxel_map;

bool voxelIsFull(ivec3 at, int level)
{
    uvec4 words = texelFetch(voxel_map, ivec3(at.xy, at.z >> 7), level);
    return (words[at.z >> 5 & 3] >> uint(at.z & 31) & 1u) != 0u;
}

struct VoxelHit {
    float way;  // to where the ray enters the voxel; less than 0: it meets none
    ivec3 at;
    int axis;   // of the face through which it enters: 0 to 2; 3: it begins there
};

// From a place along a direction, none of whose lanes is 0, at most so far. On a level above, voxels are 2^level wide along x and y.
VoxelHit voxelWalk(vec3 from, vec3 along, float most, int level)
{
    ivec3 size = ivec3(textureSize(voxel_map, level).xy, textureSize(voxel_map, 0).x);
    vec3 wide = vec3(vec2(exp2(float(level))), 1.0), over = 1.0 / along, start = from;
    vec3 low = min(-start * over, (vec3(size) * wide - start) * over), high = max(-start * over, (vec3(size) * wide - start) * over);
    float way = max(max(max(low.x, low.y), low.z), 0.0);
    most = min(most, min(min(high.x, high.y), high.z));
    int axis = way <= 0.0 ? 3 : way == low.x ? 0 : way == low.y ? 1 : 2;
    ivec3 at = clamp(ivec3(floor((start + way * along) / wide)), ivec3(0), size - 1), turn = ivec3(sign(along));
    vec3 next = ((vec3(at) + 0.5 + 0.5 * vec3(turn)) * wide - start) * over, pace = abs(wide * over);
    while (way <= most) {
        if (voxelIsFull(at, level)) return VoxelHit(way, at, axis);
        axis = next.x < next.y ? (next.x < next.z ? 0 : 2) : next.y < next.z ? 1 : 2;
        way = next[axis];
        next[axis] += pace[axis];
        at[axis] += turn[axis];
        if (at[axis] < 0 || at[axis] >= size[axis]) break;
    }
    return VoxelHit(-1.0, at, axis);
}
