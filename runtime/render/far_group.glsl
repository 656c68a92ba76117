// A group of pixels of a block, for pass_gather.glsl: those that lie near each other, and bounds of what they are. Before it stand lighting.glsl,
// far_terms.glsl and far_blocks.glsl.
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D light_depth;

layout(std430, binding = 5) writeonly buffer FarNumbers {
    float far_numbers[];
};

const int GROUP = 64, SPAN = 2, PIXELS = SPAN * SPAN; // invocations, pixels of each in x and y
const int PITCH = GROUP + 1;                          // between rows of parts, so that neighbours in a column are in other banks
const float NEAREST = 0.6; // times a light's distance, the group's radius is less where the light is far
const float NEVER = 1e30;

shared float far_parts[3 * FAR_TERMS * PITCH]; // shares of lights; then parts of sums, a row for each
shared float far_sums[3 * FAR_TERMS];
shared uint far_map[FAR_MAP];     // a bit for each pixel of the second group
shared uint far_near[FAR_NEAR];   // a bit for each light that each pixel sums by itself
shared uint far_shares[32];       // how many lights take a share of the budget between 2^-i and half of that
shared uint far_seed, far_owner;  // the depth, and the pixel, that the group is made around
shared vec3 far_point, far_axis, far_mirror; // its point, normal, and mirrored view

// The greatest of what all invocations see of some numbers, as unsigned integers of the same order.
const int LOW = 0, HIGH = 3, RADIUS = 6, NORMAL = 7, ABOVE = 8, BELOW = 9, MIRROR = 10, EVEN = 11, DIM = 14, GLOSS = 17,
          BROAD = 20, BEHIND = 21, BOUNDS = 22;
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

vec3 farBound3(int bound) { return vec3(farBound(bound), farBound(bound + 1), farBound(bound + 2)); }

// The group: the centre of its points and their greatest distance; the cone of normals around the seed's, n.(p - c) at most and at least; the cone
// of mirrored views; of its surfaces the most and the least that is even, the most that is not, and the least exponent of that.
struct Group {
    vec3 centre;
    float radius, cosine, sine, above, below, mirror, exponent;
    vec3 even, dim, gloss;
    bool behind;
};

// -- pixels

ivec2 farPixel(int k)
{
    return ivec2(gl_WorkGroupID.xy) * 8 * SPAN + ivec2(gl_LocalInvocationID.xy) + 8 * ivec2(k % SPAN, k / SPAN);
}

float farDepth(int k) { return texelFetch(light_depth, farPixel(k), 0).x; }

Seen farSeen(int k) { return lightSeen(farPixel(k), farDepth(k), unpackSurface(farPixel(k))); }

// Pixels that send back light of lamps wait for a group, as bits.
uint farBegin()
{
    uint waiting = 0u;
    for (int k = 0; k < PIXELS; k++)
        if (all(lessThan(farPixel(k), textureSize(light_depth, 0))) && farDepth(k) > 0.0 && farReflects(farSeen(k).m))
            waiting |= 1u << k;
    return waiting;
}

// -- the group

uint farNumber(int k) { return uint(k) * uint(GROUP) + gl_LocalInvocationIndex; }

// The nearest pixel that waits; of those at one depth the first. It tells the others its point. False: none waits.
bool farFindSeed(uint waiting)
{
    if (gl_LocalInvocationIndex == 0u) {
        far_seed = 0u;
        far_owner = 0xffffffffu;
    }
    if (gl_LocalInvocationIndex < uint(BOUNDS)) far_bounds[gl_LocalInvocationIndex] = 0u;
    if (gl_LocalInvocationIndex < 32u) far_shares[gl_LocalInvocationIndex] = 0u;
    if (gl_LocalInvocationIndex < uint(FAR_MAP)) far_map[gl_LocalInvocationIndex] = 0u;
    for (uint word = gl_LocalInvocationIndex; word < uint(FAR_NEAR); word += uint(GROUP))
        far_near[word] = 0u;
    barrier();
    for (int k = 0; k < PIXELS; k++)
        if ((waiting >> k & 1u) != 0u) atomicMax(far_seed, floatBitsToUint(farDepth(k)));
    barrier();
    for (int k = 0; k < PIXELS; k++)
        if ((waiting >> k & 1u) != 0u && floatBitsToUint(farDepth(k)) == far_seed) atomicMin(far_owner, farNumber(k));
    barrier();
    if (far_owner % uint(GROUP) == gl_LocalInvocationIndex && far_seed != 0u) {
        Seen seen = farSeen(int(far_owner) / GROUP);
        far_point = seen.point;
        far_axis = seen.m.normal;
        far_mirror = surfaceMirror(seen.m);
    }
    barrier();
    return far_seed != 0u;
}

// Those that wait and are near the seed, and look in a direction not far from its; in the last round all.
uint farMembers(uint waiting, bool last)
{
    const float reach = 4.0 * float(8 * SPAN), turn = 0.8;
    uint members = 0u;
    for (int k = 0; k < PIXELS; k++) {
        if ((waiting >> k & 1u) == 0u) continue;
        Seen seen = farSeen(k);
        if (last || (distance(seen.point, far_point) <= reach * seen.pixelSize && dot(seen.m.normal, far_axis) >= turn))
            members |= 1u << k;
    }
    return members;
}

Group farFindGroup(uint members)
{
    Group group;
    for (int k = 0; k < PIXELS; k++) {
        if ((members >> k & 1u) == 0u) continue;
        Seen seen = farSeen(k);
        farRaise3(HIGH, seen.point);
        farRaise3(LOW, -seen.point);
        farRaise3(EVEN, surfaceEven(seen.m));
        farRaise3(DIM, -surfaceEven(seen.m));
        farRaise3(GLOSS, surfaceGloss(seen.m));
        farRaise(BROAD, -surfaceExponent(seen.m));
        farRaise(BEHIND, surfaceLetsThrough(seen.m) ? 1.0 : 0.0);
    }
    barrier();
    group.centre = 0.5 * (farBound3(HIGH) - farBound3(LOW));
    for (int k = 0; k < PIXELS; k++) {
        if ((members >> k & 1u) == 0u) continue;
        Seen seen = farSeen(k);
        float over = dot(seen.m.normal, seen.point - group.centre);
        farRaise(RADIUS, distance(seen.point, group.centre));
        farRaise(NORMAL, -dot(seen.m.normal, far_axis));
        farRaise(ABOVE, over);
        farRaise(BELOW, -over);
        farRaise(MIRROR, -dot(surfaceMirror(seen.m), far_mirror));
    }
    barrier();
    const float rounding = 1e-6;
    group.radius = farBound(RADIUS) + rounding * length(group.centre);
    group.cosine = clamp(-farBound(NORMAL) - rounding, -1.0, 1.0);
    group.sine = sqrt(1.0 - group.cosine * group.cosine);
    group.above = farBound(ABOVE) + rounding * length(group.centre);
    group.below = -farBound(BELOW) - rounding * length(group.centre);
    group.mirror = clamp(-farBound(MIRROR) - rounding, -1.0, 1.0);
    group.even = farBound3(EVEN);
    group.dim = max(-farBound3(DIM), 0.0);
    group.gloss = farBound3(GLOSS);
    group.exponent = max(-farBound(BROAD), 0.0);
    group.behind = farBound(BEHIND) > 0.0;
    return group;
}
