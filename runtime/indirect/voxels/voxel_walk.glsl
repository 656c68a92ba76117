// Ray traversal of the slice map, voxel by voxel. Preceded by voxel_map.glsl.
uniform usampler2DArray voxel_slices; // the slice map: a texel holds 128 voxels along z
struct VoxelHit {
    // ray parameter t at which the ray enters the voxel, in multiples of the direction; < 0: no hit
    float way;
    ivec3 at;
    int axis;  // axis of the face through which the ray enters; 3: the ray begins within
    int steps; // number of voxels read
};

bool voxelSliceHas(ivec3 at, int level)
{
    return (texelFetch(voxel_slices, ivec3(at.xy, at.z >> 7),
        level)[at.z >> 5 & 3] >> uint(at.z & 31) & 1u) != 0u;
}

// Walks from a position along a direction, at most `far` times its length. On a coarser level
// voxels are 2^level wide along x and y. With `own` full voxels at the ray's start are ignored up
// to the first empty one.
VoxelHit voxelWalk(vec3 from, vec3 direction, float far, int level, bool own)
{
    VoxelWay way;
    ivec3 shift = ivec3(level, level, 0), size = ivec3(voxel_size) >> shift;
    if (!voxelSetOut(from, direction, far, way)) return VoxelHit(-1.0, ivec3(0), 3, 0);
    ivec3 at = min(ivec3(way.start) >> shift, size - 1), turn = way.turn >> shift;
    int axis = way.axis;
    float entered = 0.0;
    own = own && way.within;
    for (int steps = 1;; steps++) {
        bool full = voxelSliceHas(at ^ turn, level);
        if (full && !own)
            return VoxelHit(min((way.begin + entered) / way.scale, far), at ^ turn, axis, steps);
        own = own && full;
        vec3 lengths = voxelCrossings(way, vec3((at + 1) << shift));
        axis = voxelFirst(lengths);
        entered = lengths[axis];
        if (!(entered <= way.most)) return VoxelHit(-1.0, at, axis, steps);
        at[axis]++;
        if (at[axis] >= size[axis]) return VoxelHit(-1.0, at, axis, steps);
    }
}
