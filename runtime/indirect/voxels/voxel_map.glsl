// The scene's voxels as rays read them, and a ray through them: where it crosses the planes between
// voxels. Places are in the grid's units: voxels, from the map's lowest corner.
//
// A ray is walked as if it went up along each axis: where it goes down, voxels are counted from the
// other end, and its place is turned. It is in voxel after voxel, and which is next says one rule:
// of the planes that it has yet to cross, the one with the least t, and of several with the same t
// that across z before y before x. t of a plane is one formula of floats, voxelCrossings, whoever
// asks: so all ways through the map, by single voxels or by blocks of them, meet the same voxel at
// the same t, bit for bit.
//
//     from (0.5, 0.5, 0.5) along (1, 1, 0): both planes at 1 are crossed at t = 0.5, y first:
//         voxels (0, 0, 0), (0, 1, 0), (1, 1, 0)
#if __VERSION__ >= 400
#define VOXEL_EXACT precise
#else
#define VOXEL_EXACT
#endif
// Bricks of all levels: 4 x 4 x 4 voxels, 2^level wide, in 64 bits: bit x + 4 y + 16 z. The highest
// level is one brick, the buffer's first; each other has 8 times as many as the one above it.
uniform usamplerBuffer voxel_bricks;
#ifdef VOXEL_SIZE
const int voxel_size = VOXEL_SIZE;
#else
uniform int voxel_size; // voxels along an edge: a power of two
#endif
uniform mat4 voxel_from_eye;        // the grid's units from the eye's space
uniform float voxel_off;            // how far off a surface rays begin, in widths of a voxel

// A place, and a direction, of the eye's space. A ray's t is the same in both.
vec3 voxelPlace(vec3 eye)
{
    return (voxel_from_eye * vec4(eye, 1.0)).xyz;
}

vec3 voxelDirection(vec3 eye)
{
    return mat3(voxel_from_eye) * eye;
}

// Where a ray from a surface begins whose unit normal that is: half of what a voxel is wide along
// the normal above it, so that no voxel of a flat surface of bodies, whose middles lie below it, is
// before the ray; where open meshes are full voxels as well, whose middles lie beside it, a little
// more.
vec3 voxelStart(vec3 place, vec3 normal)
{
    return place + voxel_off * dot(abs(normal), vec3(1.0)) * normal;
}

// The number of a level's brick. How many are in the levels above is a sum of powers of 8: as many
// bits as there are of these.
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
    return (((at.z & 2) != 0 ? brick.y : brick.x) >> uint((at.x & 3) | (at.y & 3) << 2 | (at.z & 1) << 4) & 1u) != 0u;
}

// A place is in a full voxel; outside of the map nothing is full.
bool voxelAt(vec3 place)
{
    if (!all(greaterThanEqual(place, vec3(0.0))) || !all(lessThan(place, vec3(voxel_size)))) return false;
    return voxelIsFull(ivec3(place));
}

struct VoxelWay {
    vec3 start;        // in the map: where the ray begins, or comes in; turned
    vec3 along, over;  // its direction, turned: the greatest lane 1, none 0 or less; 1 over it
    ivec3 turn;        // of each axis: a voxel is number i ^ turn
    float scale;       // t of the whole ray times this is a length of this one
    float begin, most; // the length before the start; of what remains
    bool within;       // the ray begins in the map
    int axis;          // across which it comes in; 3: it begins there
};

// Lanes of a direction that are less than 1e-20 of the greatest count as that, so that none is 0.
// False: the ray, as long as it is, does not come to the map, or its direction is not between 1e-30
// and 1e30 long, or a lane is no number.
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
    uvec3 bits = max(floatBitsToUint(abs(from)), floatBitsToUint(abs(direction))); // compilers take it that no comparison has a NaN
    bool fit = all(lessThan(bits, uvec3(floatBitsToUint(longest)))) && floatBitsToUint(abs(far)) <= 0x7F800000u && way.scale > shortest;
    return fit && way.begin < longest && way.begin <= min(min(beyond.x, beyond.y), beyond.z) && way.most >= 0.0;
}

// Lengths to a plane across each axis.
vec3 voxelCrossings(VoxelWay way, vec3 planes)
{
    VOXEL_EXACT vec3 lengths = (planes - way.start) * way.over;
    return lengths;
}

int voxelFirst(vec3 lengths)
{
    return lengths.x < lengths.y ? (lengths.x < lengths.z ? 0 : 2) : lengths.y < lengths.z ? 1 : 2;
}
