// Walks through the slice map along a ray, voxel by voxel. Behind voxel_map.glsl.
struct VoxelHit {
    float way; // to where the ray enters the voxel, in multiples of its direction; less than 0: it meets none
    ivec3 at;
    int axis;  // of the face through which it enters: 0 to 2; 3: it begins there
};

// From a place along a direction, at most so many times it. On a level above, voxels are 2^level wide along x and y. `own`: of a ray that begins in full voxels those
// count only behind the first empty one.
VoxelHit voxelWalk(vec3 from, vec3 direction, float far, int level, bool own)
{
    VoxelWay way;
    ivec3 size = ivec3(textureSize(voxel_map, level).xy, textureSize(voxel_map, 0).x);
    vec3 wide = vec3(vec2(exp2(float(level))), 1.0);
    if (!voxelSetOut(from, direction, far, way)) return VoxelHit(-1.0, ivec3(0), 3);
    ivec3 at = clamp(ivec3(floor(way.start / wide)), ivec3(0), size - 1);
    int axis = way.axis;
    float entered = 0.0;
    own = own && way.within;
    for (;;) {
        bool full = voxelIsFull(at, level);
        if (full && !own) return VoxelHit(min((way.begin + entered) / way.scale, far), at, axis);
        own = own && full;
        vec3 lengths = voxelCrossings(way, (vec3(at) + vec3(way.forward)) * wide);
        axis = voxelFirst(lengths);
        entered = lengths[axis];
        if (!(entered <= way.most)) return VoxelHit(-1.0, at, axis);
        at[axis] += way.forward[axis] ? 1 : -1;
        if (at[axis] < 0 || at[axis] >= size[axis]) return VoxelHit(-1.0, at, axis);
    }
}
