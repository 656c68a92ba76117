// Ray traversal by bricks: same hit as a walk through single voxels, at the same t bit for bit, in
// fewer steps. Preceded by voxel_map.glsl.
//
// A step passes through a block 2^k voxels wide: a brick of some level, or a part of a finest
// brick, of 2 x 2 x 2 voxels or a single voxel. A mask of 64 bits selects the brick's voxels in the
// box from the ray's entry into the block to its exit. If none of them is full, the ray moves to
// the block's end, and the next block is twice as wide; otherwise the block shrinks to a quarter. A
// full block of one voxel is the hit.
//
//     A ray of slope 1/4 over an empty floor of 64 x 64 voxels: bricks 4, 8, 16, 32, ... wide,
//         which contain the floor, but not in the box that the ray passes.
struct VoxelMeeting {
    float t;    // distance in multiples of the ray's direction
    ivec3 at;   // the full voxel that was hit
    int bricks; // number of bricks read
};

// Mask of a brick's voxels between two corners of a box, both included: planes of 16 bits, of four
// rows each.
//
//     from (1, 0, 0) to (2, 1, 3): rows 0x6, planes 0x0066, all four of them: 0x00660066,
//         0x00660066
uvec2 voxelBox(ivec3 low, ivec3 high)
{
    // bit sets along each axis
    uvec3 ones = (uvec3(15u) << uvec3(low)) & (uvec3(15u) >> uvec3(3 - high));
    uint rows = ones.y & 1u | (ones.y & 2u) << 3 | (ones.y & 4u) << 6 | (ones.y & 8u) << 9;
    uvec2 planes = uvec2(ones.z, ones.z >> 2);
    return ((planes & 1u) | (planes & 2u) << 15) * (rows * ones.x);
}

bool voxelMeets(vec3 from, vec3 direction, float far, out VoxelMeeting meeting)
{
    // max steps; a walk has fewer than 3 * 512, and each step may shrink the block from every
    // second width
    const int most = 8192;
    // offset in voxels that exceeds the rounding error of a position on the ray
    const float beside = 0.002;
    VoxelWay way;
    meeting = VoxelMeeting(far, ivec3(0), 0);
    if (!voxelSetOut(from, direction, far, way)) return false;
    ivec3 at = min(ivec3(way.start), voxel_size - 1);
    vec3 start = way.start - beside;
    float entered = 0.0;
    int wide = 2, last_read = -1;
    // `own`: all full voxels so far are those in which the ray began
    bool own = way.within, met = false;
    for (int steps = 0; !met && steps < most && entered <= way.most &&
        ((at.x | at.y | at.z) & voxel_size) == 0; steps++) {
        int level = max(wide - 2, 0);
        ivec3 last = at | ((1 << wide) - 1); // last voxel of the block
        vec3 ends = voxelCrossings(way, vec3(last + 1));
        float leave = min(min(ends.x, ends.y), ends.z);
        // exit voxel, or one voxel before it
        ivec3 next = clamp(ivec3(start + leave * way.along), at, last);
        vec3 passed = voxelCrossings(way, vec3(next + 1));
        next += ivec3(passed.x < leave || ends.x < min(ends.y, ends.z), passed.y < leave ||
            (passed.y == leave && leave < ends.z), passed.z <= leave);
        ivec3 here = (at ^ way.turn) >> level, there = (min(next, last) ^ way.turn) >> level;
        int number = voxelBrickNumber(here >> 2, level);
        uvec2 full = voxelBrick(number) & voxelBox(min(here & 3, there & 3),
            max(here & 3, there & 3));
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

// Traces a ray from a position of the grid along `way`, whose length may be 1e-30 to 1e30. Returns
// whether it hits a full voxel at 0 <= t <= far; t, where the ray enters the voxel, and far are in
// multiples of `way`. Full voxels at the ray's start are ignored up to the first empty one: a ray
// that begins at voxelStart() does not hit its own surface.
bool voxelRay(vec3 from, vec3 way, float far, out float t)
{
    VoxelMeeting meeting;
    bool met = voxelMeets(from, way, far, meeting);
    t = meeting.t;
    return met;
}
