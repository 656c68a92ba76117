// Rays through voxels by bricks: what a walk through single voxels meets, at the same t bit for
// bit, in fewer steps. Behind voxel_map.glsl.
//
// A step passes through a block, 2^k voxels wide: a brick of some level, or a part of one of the
// lowest: of 2 x 2 x 2 voxels, or of one. Those voxels of the brick count that lie in the box from
// where the ray comes in to where it goes out of the block: one mask of 64 bits. If none of these
// is full, the ray goes on to the block's end, and the next is twice as wide; else a quarter as
// wide. A single voxel that is full is the hit.
//
//     a ray of slope 1/4 over an empty floor of 64 x 64 voxels: bricks 4, 8, 16, 32, ... wide,
//         which have the floor, but not in the box that the ray passes
struct VoxelMeeting {
    float t;    // in multiples of the ray's direction
    ivec3 at;   // the voxel
    int bricks; // that were read
};

// The voxels of a brick from one corner of a box to the other, both within: planes of 16 bits, of
// four rows.
//
//     from (1, 0, 0) to (2, 1, 3): rows 0x6, planes 0x0066, all four of them: 0x00660066,
//         0x00660066
uvec2 voxelBox(ivec3 low, ivec3 high)
{
    uvec3 ones = (uvec3(15u) << uvec3(low)) & (uvec3(15u) >> uvec3(3 - high)); // of each axis
    uint rows = ones.y & 1u | (ones.y & 2u) << 3 | (ones.y & 4u) << 6 | (ones.y & 8u) << 9;
    uvec2 planes = uvec2(ones.z, ones.z >> 2);
    return ((planes & 1u) | (planes & 2u) << 15) * (rows * ones.x);
}

bool voxelMeets(vec3 from, vec3 direction, float far, out VoxelMeeting meeting)
{
    const int most = 8192;      // steps; a walk has fewer than 3 * 512, and each can go down once from each second width
    const float beside = 0.002; // voxels: more than a place of a ray is off that is computed in floats
    VoxelWay way;
    meeting = VoxelMeeting(far, ivec3(0), 0);
    if (!voxelSetOut(from, direction, far, way)) return false;
    ivec3 at = min(ivec3(way.start), voxel_size - 1);
    vec3 start = way.start - beside;
    float entered = 0.0;
    int wide = 2, last_read = -1;
    bool own = way.within, met = false; // own: all voxels so far were full, in which it began
    for (int steps = 0; !met && steps < most && entered <= way.most && ((at.x | at.y | at.z) & voxel_size) == 0; steps++) {
        int level = max(wide - 2, 0);
        ivec3 last = at | ((1 << wide) - 1); // of the block
        vec3 ends = voxelCrossings(way, vec3(last + 1));
        float leave = min(min(ends.x, ends.y), ends.z);
        ivec3 next = clamp(ivec3(start + leave * way.along), at, last); // where it leaves, or one voxel before that
        vec3 passed = voxelCrossings(way, vec3(next + 1));
        next += ivec3(passed.x < leave || ends.x < min(ends.y, ends.z), passed.y < leave || (passed.y == leave && leave < ends.z), passed.z <= leave);
        ivec3 here = (at ^ way.turn) >> level, there = (min(next, last) ^ way.turn) >> level;
        int number = voxelBrickNumber(here >> 2, level);
        uvec2 full = voxelBrick(number) & voxelBox(min(here & 3, there & 3), max(here & 3, there & 3));
        bool clear = (full.x | full.y) == 0u;
        meeting.bricks += int(number != last_read);
        last_read = number;
        own = own && !clear;
        met = !clear && wide == 0 && !own;
        if (clear || (own && wide == 0)) {
            at = next;
            entered = leave;
        }
        wide = clear ? wide + int(voxel_size >> wide > 1) : max(wide - 2, 0);
    }
    meeting.t = min((way.begin + entered) / way.scale, far);
    meeting.at = at ^ way.turn;
    return met && entered <= way.most;
}

// A ray from a place of the grid along `way`, of any length from 1e-30 to 1e30, meets a full voxel
// at 0 <= t <= far; t, where it enters it, and far are in multiples of `way`. Full voxels in which
// it begins do not count, up to the first empty one: what begins where voxelStart says does not
// meet the surface that it comes from.
bool voxelRay(vec3 from, vec3 way, float far, out float t)
{
    VoxelMeeting meeting;
    bool met = voxelMeets(from, way, far, meeting);
    t = meeting.t;
    return met;
}
