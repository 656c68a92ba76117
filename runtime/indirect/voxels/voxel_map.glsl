// The voxel grid as rays read it, and the traversal of a ray: its crossings of the planes between
// voxels. Positions are in grid units: voxels, from the grid's lowest corner.
//
// A ray is traversed as if it went up along each axis: along a descending axis voxels are counted
// from the other end, and positions are mirrored. One rule determines the next voxel: of the planes
// not yet crossed, the one with the smallest t; of planes with equal t, the one across z before y
// before x. The t of a plane is always computed by the same float formula, voxelCrossings. So all
// traversals, by single voxels or by blocks, hit the same voxel at the same t, bit for bit.
//
//     from (0.5, 0.5, 0.5) along (1, 1, 0): both planes at 1 are crossed at t = 0.5, y first:
//         voxels (0, 0, 0), (0, 1, 0), (1, 1, 0)
#if __VERSION__ >= 400
#define VOXEL_EXACT precise
#else
#define VOXEL_EXACT
#endif
// Bricks of all levels: 4 x 4 x 4 voxels, each 2^level wide, in 64 bits: bit x + 4 y + 16 z. The
// coarsest level is one brick, the buffer's first; each finer level has 8 times as many.
uniform usamplerBuffer voxel_bricks;
#ifdef VOXEL_SIZE
const int voxel_size = VOXEL_SIZE;
#else
uniform int voxel_size; // voxels along an edge: a power of two
#endif
uniform mat4 voxel_from_eye;        // matrix from eye space to grid units
uniform float voxel_off;            // start offset of rays from a surface, in voxel widths

// Transform a position and a direction from eye space. A ray's t is the same in both spaces.
vec3 voxelPlace(vec3 eye)
{
    return (voxel_from_eye * vec4(eye, 1.0)).xyz;
}

vec3 voxelDirection(vec3 eye)
{
    return mat3(voxel_from_eye) * eye;
}

// Returns the start of a ray from a surface with a unit normal: above it by half a voxel's width
// along the normal, so that full voxels of a flat body, whose centers lie below the surface, are
// not in the ray's way. If the scene has open meshes, whose full voxels have centers on either
// side, the offset is a little larger.
vec3 voxelStart(vec3 place, vec3 normal)
{
    return place + voxel_off * dot(abs(normal), vec3(1.0)) * normal;
}

// Returns the number of a brick of a level. The bricks of all coarser levels number a sum of powers
// of 8, one bit per level, selected by the mask.
int voxelBrickNumber(ivec3 at, int level)
{
    int edge = voxel_size >> (level + 2);
    return ((edge * edge * edge - 1) & 0x49249249) + (at.z * edge + at.y) * edge + at.x;
}

uvec2 voxelBrick(int number)
{
    return texelFetch(voxel_bricks, number).xy;
}

bool voxelIsFull(ivec3 at)
{
    uvec2 brick = voxelBrick(voxelBrickNumber(at >> 2, 0));
    return (((at.z & 2) != 0 ? brick.y
        : brick.x) >> uint((at.x & 3) | (at.y & 3) << 2 | (at.z & 1) << 4) & 1u) != 0u;
}

// Reports whether a position is in a full voxel; outside the grid all voxels are empty.
bool voxelAt(vec3 place)
{
    if (!all(greaterThanEqual(place, vec3(0.0))) || !all(lessThan(place, vec3(voxel_size))))
        return false;
    return voxelIsFull(ivec3(place));
}

struct VoxelWay {
    vec3 start;        // start in the grid, or where the ray enters it; mirrored
    vec3 along, over;  // mirrored direction: largest component 1, all > 0; its reciprocal
    ivec3 turn;        // the mirrored grid's voxel i along an axis is voxel i ^ turn
    float scale;       // length along the mirrored ray = t of the original ray * scale
    float begin, most; // length before the start; max length after it
    bool within;       // the ray begins in the grid
    int axis;          // axis of the face through which the ray enters; 3: the ray begins within
};

// Prepares a traversal. Components of a direction below 1e-20 of the largest are raised to that
// value, so that none is 0. Returns false if the ray does not reach the grid, its direction is not
// between 1e-30 and 1e30 long, or a component is not a number.
bool voxelSetOut(vec3 from, vec3 direction, float far, out VoxelWay way)
{
    const float least = 1e-20, shortest = 1e-30, longest = 1e30;
    float size = float(voxel_size);
    way.scale = max(max(abs(direction.x), abs(direction.y)), abs(direction.z));
    bvec3 down = lessThan(direction, vec3(-least * way.scale));
    vec3 place = mix(from, size - from, down);
    way.turn = (voxel_size - 1) * ivec3(down);
    way.along = max(abs(direction) / way.scale, vec3(least));
    way.over = 1.0 / way.along;
    vec3 near = -place * way.over, beyond = (size - place) * way.over;
    way.begin = max(max(near.x, near.y), max(near.z, 0.0));
    way.within = all(greaterThanEqual(from, vec3(0.0))) && all(lessThanEqual(from, vec3(size)));
    way.axis = way.within ? 3 : way.begin == near.x ? 0 : way.begin == near.y ? 1 : 2;
    if (way.within) way.begin = 0.0;
    way.start = clamp(place + way.begin * way.along, vec3(0.0), vec3(size));
    way.most = far * way.scale - way.begin;
    // bit comparisons, since compilers assume that floats are never NaN
    uvec3 bits = max(floatBitsToUint(abs(from)), floatBitsToUint(abs(direction)));
    bool fit = all(lessThan(bits, uvec3(floatBitsToUint(longest)))) &&
        floatBitsToUint(abs(far)) <= 0x7F800000u && way.scale > shortest;
    return fit && way.begin < longest && way.begin <= min(min(beyond.x, beyond.y), beyond.z) &&
        way.most >= 0.0;
}

// Returns the lengths along the ray to a plane across each axis.
vec3 voxelCrossings(VoxelWay way, vec3 planes)
{
    VOXEL_EXACT vec3 lengths = (planes - way.start) * way.over;
    return lengths;
}

int voxelFirst(vec3 lengths)
{
    return lengths.x < lengths.y ? (lengths.x < lengths.z ? 0 : 2) : lengths.y < lengths.z ? 1 : 2;
}
