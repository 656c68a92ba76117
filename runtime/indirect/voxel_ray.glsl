// Rays through the slice map by its levels: what a walk through single voxels meets, at the same t bit for bit, in fewer steps. Behind voxel_map.glsl.
//
// A step reads one word: of a level, 32 voxels along z of a column 2^level wide. Those of them count that the ray passes while it is in the column, from where it
// comes in to where it goes out along z. If none of these is full, the ray goes on to the column's end, and the next step takes one that is twice as wide; else the next takes
// one a quarter as wide, and on the lowest level the first of these is the hit. (One half as wide reads a hundredth more words.)
//
//     a ray of slope 1/4 over an empty floor of 64 x 64 voxels: columns 1, 2, 4, 8, ... wide, whose words have the floor, but not the voxels that the ray passes
struct VoxelMeeting {
    float t;   // in multiples of the ray's direction
    ivec3 at;  // the voxel
    int steps; // words that were read
};

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

// A ray that begins in a full voxel goes on, voxel by voxel, to the first empty one. False: there is none on its way.
bool voxelLeave(VoxelWay way, inout ivec3 at, inout float entered, inout int steps)
{
    for (bool full = true; full; steps++) {
        vec3 lengths = voxelCrossings(way, vec3(at + 1));
        int axis = voxelFirst(lengths);
        entered = min(min(lengths.x, lengths.y), lengths.z);
        at += ivec3(axis == 0, axis == 1, axis == 2);
        if (!(entered <= way.most) || any(greaterThanEqual(at, ivec3(voxel_size)))) return false;
        full = voxelIsFull(at ^ way.turn, 0);
    }
    return true;
}

bool voxelMeets(vec3 from, vec3 direction, float far, out VoxelMeeting meeting)
{
    const int most = 8192;      // steps; a walk has fewer than 3 * 512, and each can go down once from each second level
    const float beside = 0.002; // voxels: more than a place of a ray is off that is computed in floats
    VoxelWay way;
    meeting = VoxelMeeting(far, ivec3(0), 0);
    if (!voxelSetOut(from, direction, far, way)) return false;
    ivec3 at = min(ivec3(way.start), voxel_size - 1);
    int level = 0, steps = 1;
    float entered = 0.0;
    if (way.within && voxelIsFull(at ^ way.turn, 0) && !voxelLeave(way, at, entered, steps)) {
        meeting.steps = steps;
        return false;
    }
    vec3 start = way.start - beside;
    uint met = 0u;
    for (; steps < most; steps++) {
        ivec3 last = at | ivec3(ivec2((1 << level) - 1), 31); // of the column
        vec3 ends = voxelCrossings(way, vec3(last + 1));
        float leave = min(min(ends.x, ends.y), ends.z);
        ivec3 next = clamp(ivec3(start + leave * way.along), at, last); // where it leaves, or one voxel before that
        vec3 passed = voxelCrossings(way, vec3(next + 1));
        next += ivec3(passed.x < leave || ends.x < min(ends.y, ends.z), passed.y < leave || (passed.y == leave && leave < ends.z), passed.z <= leave);
        int here = (at.z ^ way.turn.z) & 31, there = (min(next.z, last.z) ^ way.turn.z) & 31;
        uint within = (0xFFFFFFFFu << uint(min(here, there))) & (0xFFFFFFFFu >> uint(31 - max(here, there)));
        met = voxelWord((at.xy ^ way.turn.xy) >> level, at.z ^ way.turn.z, level) & within;
        bool clear = met == 0u;
        if (!clear && level == 0) break;
        at = clear ? next : at;
        entered = clear ? leave : entered;
        level = clear ? level + int(voxel_size >> level > 1) : max(level - 2, 0);
        if (!(entered <= way.most) || ((at.x | at.y | at.z) & voxel_size) != 0) break;
    }
    meeting.steps = steps;
    if (met == 0u || level > 0) return false;
    int z = ((at.z ^ way.turn.z) & -32 | voxelBit(met, way.turn.z == 0)) ^ way.turn.z;
    if (z != at.z) entered = voxelCrossings(way, vec3(z)).z;
    meeting.t = min((way.begin + entered) / way.scale, far);
    meeting.at = ivec3(at.xy, z) ^ way.turn;
    return entered <= way.most;
}

// A ray from a place of the grid along `way`, of any length from 1e-30 to 1e30, meets a full voxel at 0 <= t <= far; t, where it enters it, and far are in multiples of `way`.
// Full voxels in which it begins do not count, up to the first empty one: what begins where voxelStart says does not meet the surface that it comes from.
bool voxelRay(vec3 from, vec3 way, float far, out float t)
{
    VoxelMeeting meeting;
    bool met = voxelMeets(from, way, far, meeting);
    t = meeting.t;
    return met;
}
