// The first dispatch of the pass light_cluster: groups of a block's pixels, and bounds of their
// surfaces. Preceded by far_group.glsl.
layout(local_size_x = FAR_INVOCATIONS) in;
uniform sampler2D light_depth;

// invocations; sets of pixels per invocation
const int GROUP = FAR_INVOCATIONS, SETS = FAR_MAP / GROUP;
// pixels per set: 8 apart, so that adjacent pixels belong to adjacent invocations
const int PIXELS = FAR_SPAN * FAR_SPAN;

// The pixel around which a group is built: its point, normal and mirrored view, and its specular
// exponent.
struct Seed {
    vec3 point, axis, mirror;
    float exponent;
};

shared uint far_nearest, far_owner; // the seed's depth, and its pixel number
shared Seed far_seed;

// Maxima over all invocations, of floats mapped to unsigned integers of the same order.
const int LOW = 0, HIGH = 3, NORMAL = 6, ABOVE = 7, BELOW = 8, MIRROR = 9, EVEN = 10, DIM = 13,
    SPECULAR = 16, BROAD = 19,
          SHARP = 20, BEHIND = 21, BOUNDS = 22;
shared uint far_bounds[BOUNDS];

uint farOrdered(float x)
{
    uint bits = floatBitsToUint(x);
    return bits >> 31 != 0u ? ~bits : bits | 0x80000000u;
}

void farRaise(int bound, float x) { atomicMax(far_bounds[bound], farOrdered(x)); }

void farRaise3(int bound, vec3 x)
{
    farRaise(bound, x.x);
    farRaise(bound + 1, x.y);
    farRaise(bound + 2, x.z);
}

float farBound(int bound)
{
    uint ordered = far_bounds[bound];
    return uintBitsToFloat(ordered >> 31 != 0u ? ordered & 0x7fffffffu : ~ordered);
}

vec3 farBound3(int bound)
{
    return vec3(farBound(bound), farBound(bound + 1), farBound(bound + 2));
}

// -- pixels

// Returns the number of this invocation's i-th set of pixels.
int farSet(int i) { return i * GROUP + int(gl_LocalInvocationIndex); }

ivec2 farPixel(int set, int k)
{
    return ivec2(gl_WorkGroupID.xy) * FAR_BLOCK + ivec2(set & 7, set >> 3) +
        8 * ivec2(k % FAR_SPAN, k / FAR_SPAN);
}

float farDepth(int set, int k) { return texelFetch(light_depth, farPixel(set, k), 0).x; }

Seen farSeen(int set, int k)
{
    ivec2 pixel = farPixel(set, k);
    return lightSeen(pixel, farDepth(set, k), unpackSurface(pixel));
}

uint farNumber(int set, int k) { return uint(k * FAR_MAP + set); }

// Returns the pixels of a set with a surface that reflects or transmits light of lamps, as bits.
uint farBegin(int set)
{
    uint waiting = 0u;
    for (int k = 0; k < PIXELS; k++)
        if (all(lessThan(farPixel(set, k), textureSize(light_depth, 0))) &&
            farDepth(set, k) > 0.0 && farReflects(farSeen(set, k).m))
            waiting |= 1u << k;
    return waiting;
}

// -- groups

void farClear()
{
    if (gl_LocalInvocationIndex == 0u) {
        far_nearest = 0u;
        far_owner = 0xffffffffu;
    }
    for (int i = int(gl_LocalInvocationIndex); i < BOUNDS; i += GROUP)
        far_bounds[i] = 0u;
    barrier();
}

// Selects the nearest waiting pixel as seed; among pixels of equal depth the one with the smallest
// number. Its invocation shares the seed. Returns false if no pixel waits.
bool farFindSeed(uint waiting[SETS])
{
    float nearest = 0.0;
    uint first = 0u;
    farClear();
    for (int i = 0; i < SETS; i++)
        for (uint left = waiting[i]; left != 0u; left &= left - 1u) {
            float depth = farDepth(farSet(i), findLSB(left));
            uint number = farNumber(farSet(i), findLSB(left));
            if (depth > nearest || (depth == nearest && number < first)) first = number;
            nearest = max(nearest, depth);
        }
    if (nearest > 0.0) atomicMax(far_nearest, floatBitsToUint(nearest));
    barrier();
    if (nearest > 0.0 && floatBitsToUint(nearest) == far_nearest) atomicMin(far_owner, first);
    barrier();
    if (nearest > 0.0 && first == far_owner) {
        Seen seen = farSeen(int(first) % FAR_MAP, int(first) / FAR_MAP);
        far_seed = Seed(seen.point, seen.m.normal, surfaceMirror(seen.m), surfaceExponent(seen.m));
    }
    barrier();
    return far_nearest != 0u;
}

bool farShines(Lit m) { return any(greaterThan(surfaceSpecular(m), vec3(0.0))); }

// Reports whether a pixel is close to the seed and has a similar normal and specular lobe.
bool farIsAlike(Seen seen, Seed seed)
{
    const float reach = 4.0 * float(FAR_BLOCK), turn = 0.8, sharper = 0.2;
    return distance(seen.point, seed.point) <= reach * seen.pixelSize &&
        dot(seen.m.normal, seed.axis) >= turn &&
           (!farShines(seen.m) || abs(surfaceExponent(seen.m) - seed.exponent) <= sharper *
               seed.exponent);
}

// Moves waiting pixels that are similar to the seed into a group; the last group takes all
// remaining ones. Each invocation combines its own pixels before it updates the shared bounds.
void farSpread(int group, inout uint waiting[SETS], inout uint map[SETS])
{
    bool last = group == FAR_GROUPS - 1, some = false;
    // reads the shared seed once: some drivers serialize reads of shared memory
    Seed seed = far_seed;
    vec3 high = vec3(-NEVER), low = high, even = high, dim = high, specular = high;
    float normal = -NEVER, above = normal, below = normal, mirror = normal, broad = normal,
        sharp = normal, behind = 0.0;
    for (int i = 0; i < SETS; i++)
        for (uint left = waiting[i]; left != 0u; left &= left - 1u) {
            Seen seen = farSeen(farSet(i), findLSB(left));
            if (!last && !farIsAlike(seen, seed)) continue;
            some = true;
            waiting[i] &= ~(left & ~(left - 1u));
            map[i] |= uint(group) << 2 * findLSB(left);
            vec3 way = seen.point - seed.point;
            high = max(high, way);
            low = max(low, -way);
            above = max(above, dot(seen.m.normal, way));
            below = max(below, -dot(seen.m.normal, way));
            normal = max(normal, -dot(seen.m.normal, seed.axis));
            even = max(even, surfaceEven(seen.m));
            dim = max(dim, -surfaceEven(seen.m));
            specular = max(specular, surfaceSpecular(seen.m));
            if (farShines(seen.m)) {
                mirror = max(mirror, -dot(surfaceMirror(seen.m), seed.mirror));
                broad = max(broad, -surfaceExponent(seen.m));
                sharp = max(sharp, surfaceExponent(seen.m));
            }
            behind = surfaceLetsThrough(seen.m) ? 1.0 : behind;
        }
    if (!some) return;
    farRaise3(HIGH, high);
    farRaise3(LOW, low);
    farRaise3(EVEN, even);
    farRaise3(DIM, dim);
    farRaise3(SPECULAR, specular);
    farRaise(NORMAL, normal);
    farRaise(ABOVE, above);
    farRaise(BELOW, below);
    farRaise(MIRROR, mirror);
    farRaise(BROAD, broad);
    farRaise(SHARP, sharp);
    farRaise(BEHIND, behind);
}

// Computes the group's bounds. Heights above the seed are converted to heights above the center by
// subtracting n.(c - s).
Group farFindGroup()
{
    const float rounding = 1e-6;
    Group group;
    vec3 high = farBound3(HIGH), low = -farBound3(LOW), way = 0.5 * (high + low);
    group.centre = far_seed.point + way;
    group.axis = far_seed.axis;
    group.view = far_seed.mirror;
    float far = rounding * length(group.centre), off = length(way);
    group.radius = 0.5 * length(high - low) + far;
    group.cosine = clamp(-farBound(NORMAL) - rounding, -1.0, 1.0);
    group.sine = sqrt(1.0 - group.cosine * group.cosine);
    vec2 higher = off * farCosines(off > 0.0 ? dot(way, group.axis) / off : 1.0, group.cosine,
        group.sine);
    group.above = farBound(ABOVE) - higher.x + far;
    group.below = -farBound(BELOW) - higher.y - far;
    group.mirror = clamp(-farBound(MIRROR) - rounding, -1.0, 1.0);
    group.even = farBound3(EVEN);
    group.dim = max(-farBound3(DIM), 0.0);
    group.specular = farBound3(SPECULAR);
    group.exponent = clamp(-farBound(BROAD), 0.0, 65504.0);
    group.turn = sqrt(2.0 - 2.0 * group.mirror);
    group.lean = sqrt(2.0 - 2.0 * group.cosine);
    group.spread = max(farBound(SHARP) - group.exponent, 0.0) / (2.718 * max(group.exponent, 1e-3));
    group.behind = farBound(BEHIND) > 0.0;
    return group;
}

// -- results

void farPut(int at, vec3 numbers)
{
    far_numbers[at] = numbers.x;
    far_numbers[at + 1] = numbers.y;
    far_numbers[at + 2] = numbers.z;
}

void farKeep(Group group, int number)
{
    int at = farPlace(number);
    farPut(at + GROUP_CENTER, group.centre);
    farPut(at + GROUP_AXIS, group.axis);
    farPut(at + GROUP_VIEW, group.view);
    far_numbers[at + GROUP_RADIUS] = group.radius;
    far_numbers[at + GROUP_COSINE] = group.cosine;
    far_numbers[at + GROUP_SINE] = group.sine;
    far_numbers[at + GROUP_ABOVE] = group.above;
    far_numbers[at + GROUP_BELOW] = group.below;
    far_numbers[at + GROUP_MIRROR] = group.mirror;
    farPut(at + GROUP_EVEN, group.even);
    farPut(at + GROUP_DIM, group.dim);
    farPut(at + GROUP_SPECULAR, group.specular);
    far_numbers[at + GROUP_EXPONENT] = group.exponent;
    far_numbers[at + GROUP_TURN] = group.turn;
    far_numbers[at + GROUP_LEAN] = group.lean;
    far_numbers[at + GROUP_SPREAD] = group.spread;
    far_numbers[at + GROUP_BEHIND] = group.behind ? 1.0 : 0.0;
}

void main()
{
    uint waiting[SETS], map[SETS];
    for (int i = 0; i < SETS; i++) {
        waiting[i] = farBegin(farSet(i));
        map[i] = 0u;
    }
    int number = 0;
    for (; number < FAR_GROUPS && farFindSeed(waiting); number++) {
        farSpread(number, waiting, map);
        barrier();
        if (gl_LocalInvocationIndex == 0u) farKeep(farFindGroup(), number);
        barrier();
    }
    for (; number < FAR_GROUPS; number++)
        if (gl_LocalInvocationIndex == 0u) far_numbers[farPlace(number) + GROUP_RADIUS] = -1.0;
    for (int i = 0; i < SETS; i++)
        far_words[farBlock() * FAR_WORDS + farSet(i)] = map[i];
}
