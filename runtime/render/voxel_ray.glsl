// Rays through the slice map by its levels: what a walk through single voxels meets, at the same t bit for bit, in fewer steps. Behind voxel_map.glsl.
//
// A step reads one word: of a level, 32 voxels along z of a column 2^level wide. Those of them count that the ray passes while it is in the column, from where it
// comes in to where it goes out along z. If none of these is full, the ray goes on to the column's end, and the next step takes one that is twice as wide; else the next takes
// one half as wide, and on the lowest level the first of these is the hit.
//
//     a ray of slope 1/4 over an empty floor of 64 x 64 voxels: columns 1, 2, 4, 8, ... wide, whose words have the floor, but not the voxels that the ray passes
struct VoxelMeeting {
    float t;   // in multiples of the ray's direction
    ivec3 at;  // the voxel
    int steps; // words that were read
};

// Voxels in which a ray is that has gone so far: behind all planes that come before plane `axis` at that length; -1: behind those at it, too.
ivec3 voxelPassed(VoxelWay way, float gone, int axis)
{
    ivec3 guess = ivec3(floor(way.start + gone * way.along)), turn = ivec3(mix(vec3(-1.0), vec3(1.0), way.forward));
    vec3 enter = voxelCrossings(way, vec3(guess) + 1.0 - vec3(way.forward)), leave = voxelCrossings(way, vec3(guess) + vec3(way.forward));
    bvec3 first = greaterThan(ivec3(0, 1, 2), ivec3(axis));
    bvec3 left = bvec3(first.x ? leave.x <= gone : leave.x < gone, first.y ? leave.y <= gone : leave.y < gone, first.z ? leave.z <= gone : leave.z < gone);
    bvec3 entered = bvec3(first.x ? enter.x <= gone : enter.x < gone, first.y ? enter.y <= gone : enter.y < gone, first.z ? enter.z <= gone : enter.z < gone);
    return guess + turn * (ivec3(left) - ivec3(not(entered)));
}

// The lowest bit of a word that is not 0, or its highest.
int voxelBit(uint word, bool lowest)
{
#if __VERSION__ >= 400
    return lowest ? findLSB(word) : findMSB(word);
#else // a float of a power of two, or of what begins with bits 10, has its number as exponent
    uint one = lowest ? word & (~word + 1u) : word & ~(word >> 1);
    return (floatBitsToInt(float(one)) >> 23) - 127;
#endif
}

bool voxelMeets(vec3 from, vec3 direction, float far, out VoxelMeeting meeting)
{
    const int most = 8192; // steps; a walk has fewer than 3 * 512, and each can go down once from each level
    VoxelWay way;
    meeting = VoxelMeeting(far, ivec3(0), 0);
    if (!voxelSetOut(from, direction, far, way)) return false;
    int size = textureSize(voxel_map, 0).x, level = 0;
    ivec3 at = clamp(ivec3(floor(way.start)), ivec3(0), ivec3(size - 1));
    float entered = 0.0;
    bool own = way.within;
    for (meeting.steps = 1; meeting.steps < most; meeting.steps++) {
        ivec3 edge = ivec3(ivec2(1 << level), 32), low = at & -edge;
        vec3 lengths = voxelCrossings(way, mix(vec3(low), vec3(low + edge), way.forward));
        int axis = voxelFirst(lengths);
        float leave = min(min(lengths.x, lengths.y), lengths.z);
        bool last = leave > way.most;
        if (last) {
            leave = way.most;
            axis = -1;
        }
        ivec3 here = low, there = low + edge - 1; // what the ray can pass of the column
        here = ivec3(way.forward.x ? at.x : here.x, way.forward.y ? at.y : here.y, way.forward.z ? at.z : here.z);
        there = ivec3(way.forward.x ? there.x : at.x, way.forward.y ? there.y : at.y, way.forward.z ? there.z : at.z);
        ivec3 next = clamp(voxelPassed(way, leave, axis), here, there);
        int lowest = min(at.z, next.z) & 31, highest = max(at.z, next.z) & 31;
        uint within = (0xFFFFFFFFu << uint(lowest)) & (0xFFFFFFFFu >> uint(31 - highest));
        uint word = texelFetch(voxel_map, ivec3(at.xy >> level, at.z >> 7), level)[at.z >> 5 & 3];
        uint met = (own ? ~word : word) & within;
        if (met != 0u && level > 0) {
            level--;
            continue;
        }
        if (met != 0u && own) { // the first empty voxel: what comes behind it counts
            uint bit = 1u << uint(voxelBit(met, way.forward.z));
            met = word & within & (way.forward.z ? ~(bit - 1u) : bit - 1u);
            own = false;
        }
        if (met != 0u) {
            int z = (at.z & -32) + voxelBit(met, way.forward.z);
            if (z != at.z) entered = voxelCrossings(way, vec3(z + (way.forward.z ? 0 : 1))).z;
            meeting.t = min((way.begin + entered) / way.scale, far);
            meeting.at = ivec3(at.xy, z);
            return true;
        }
        if (last) return false;
        at = ivec3(axis == 0 ? (way.forward.x ? low.x + edge.x : low.x - 1) : next.x, axis == 1 ? (way.forward.y ? low.y + edge.y : low.y - 1) : next.y,
                   axis == 2 ? (way.forward.z ? low.z + edge.z : low.z - 1) : next.z);
        if (any(lessThan(at, ivec3(0))) || any(greaterThanEqual(at, ivec3(size)))) return false;
        entered = leave;
        if (!own && size >> (level + 1) > 0) level++;
    }
    return false;
}

// A ray from a place of the grid along `way`, of any length from 1e-30 to 1e30, meets a full voxel at 0 <= t <= far; t, where it enters it, and far are in multiples of `way`.
// Full voxels in which it begins do not count, up to the first empty one: what begins half a voxel off a surface does not meet that.
bool voxelRay(vec3 from, vec3 way, float far, out float t)
{
    VoxelMeeting meeting;
    bool met = voxelMeets(from, way, far, meeting);
    t = meeting.t;
    return met;
}
