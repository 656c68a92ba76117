// Builds the bricks of a level: 4 x 4 x 4 voxels in 64 bits. The finest level is read from the
// slice map; in a coarser one 2 x 2 x 2 bricks become one, and a voxel is the union of 2 x 2 x 2.
// voxel_map.glsl describes the order of bricks and of their bits.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(std430, binding = 2) buffer VoxelBricks {
    uvec2 bricks[];
};
uniform usampler2DArray brick_map;
uniform int brick_log; // log2 of the number of bricks along an edge of the level
uniform bool brick_lowest;

int brickPlace(ivec3 at, int log_)
{
    return (((1 << 3 * log_) - 1) & 0x49249249) + (((at.z << log_) + at.y) << log_) + at.x;
}

// Builds the bricks of 4 x 4 columns: a texel holds 128 voxels of a layer, which makes 32 bricks.
void bricksOfMap(ivec3 at)
{
    uvec4 columns[16];
    for (int i = 0; i < 16; i++)
        columns[i] = texelFetch(brick_map, ivec3(4 * at.xy + ivec2(i & 3, i >> 2), at.z), 0);
    for (int z = 0; z < min(1 << brick_log, 32); z++) {
        uvec2 brick = uvec2(0u);
        for (int i = 0; i < 16; i++) {
            uint four = columns[i][z >> 3] >> uint(4 * (z & 7));
            brick |= (uvec2(four & 1u, four >> 2u & 1u) | uvec2(four >> 1u & 1u,
                four >> 3u & 1u) << 16u) << uint(i);
        }
        bricks[brickPlace(ivec3(at.xy, 32 * at.z + z), brick_log)] = brick;
    }
}

// Halves two planes of 4 x 4 voxels, in 16 bits each: the union of each 2 x 2 x 2 becomes one
// voxel, in bits 0, 1, 4, and 5.
uint brickQuarter(uint planes)
{
    uint any = (planes | planes >> 16u) & 0xFFFFu;
    any |= any >> 1u;
    any |= any >> 4u;
    return (any & 1u) | (any >> 1u & 2u) | (any >> 4u & 16u) | (any >> 5u & 32u);
}

void brickAbove(ivec3 at)
{
    uvec2 brick = uvec2(0u);
    for (int i = 0; i < 8; i++) {
        uvec2 below = bricks[brickPlace(2 * at + ivec3(i & 1, i >> 1 & 1, i >> 2), brick_log + 1)];
        brick[i >> 2] |= (brickQuarter(below.x) | brickQuarter(below.y) << 16u) << uint(2 *
            (i & 1) + 8 * (i >> 1 & 1));
    }
    bricks[brickPlace(at, brick_log)] = brick;
}

void main()
{
    ivec3 at = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(at.xy, ivec2(1 << brick_log))) ||
        at.z >= (brick_lowest ? textureSize(brick_map, 0).z : 1 << brick_log))
        return;
    if (brick_lowest) bricksOfMap(at);
    else brickAbove(at);
}
