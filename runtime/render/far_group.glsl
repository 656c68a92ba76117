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

// What a group asks of a pixel; `size` is a pixel's, there.
struct Member {
    vec3 point, normal, mirror, even, gloss;
    float size, exponent;
    bool behind;
};

// Pixels at which there is a surface, as bits.
uint farBegin()
{
    uint waiting = 0u;
    for (int k = 0; k < PIXELS; k++)
        if (all(lessThan(farPixel(k), textureSize(light_depth, 0))) && farDepth(k) > 0.0) waiting |= 1u << k;
    return waiting;
}

// Looks at those that wait. Returns the ones among them that send back light of lamps.
uint farLook(uint waiting, out Member pixels[PIXELS])
{
    for (int k = 0; k < PIXELS; k++) {
        if ((waiting >> k & 1u) == 0u) continue;
        Seen seen = lightSeen(farPixel(k), farDepth(k), unpackSurface(farPixel(k)));
        Lit m = seen.m;
        pixels[k] = Member(seen.point, m.normal, surfaceMirror(m), surfaceEven(m), surfaceGloss(m), seen.pixelSize,
                           surfaceExponent(m), surfaceLetsThrough(m));
        if (!farReflects(m)) waiting &= ~(1u << k);
    }
    return waiting;
}

// -- the group

uint farNumber(int k) { return uint(k) * uint(GROUP) + gl_LocalInvocationIndex; }

// The nearest pixel that waits; of those at one depth the first. It tells the others its point. False: none waits.
bool farFindSeed(uint waiting, Member pixels[PIXELS])
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
    for (int k = 0; k < PIXELS; k++)
        if (farNumber(k) == far_owner && far_seed != 0u) {
            far_point = pixels[k].point;
            far_axis = pixels[k].normal;
            far_mirror = pixels[k].mirror;
        }
    barrier();
    return far_seed != 0u;
}

// Those that wait and are near the seed, and look in a direction not far from its; in the last round all.
uint farMembers(uint waiting, Member pixels[PIXELS], bool last)
{
    const float reach = 4.0 * float(8 * SPAN), turn = 0.8;
    uint members = 0u;
    for (int k = 0; k < PIXELS; k++) {
        if ((waiting >> k & 1u) == 0u) continue;
        bool near = distance(pixels[k].point, far_point) <= reach * pixels[k].size;
        if (last || (near && dot(pixels[k].normal, far_axis) >= turn))
            members |= 1u << k;
    }
    return members;
}

// Each invocation puts its pixels together before it tells the others of them.
void farSpread(uint members, Member pixels[PIXELS])
{
    vec3 high = vec3(-NEVER), low = high, even = high, dim = high, gloss = high;
    float broad = -NEVER, behind = 0.0;
    for (int k = 0; k < PIXELS; k++) {
        if ((members >> k & 1u) == 0u) continue;
        high = max(high, pixels[k].point);
        low = max(low, -pixels[k].point);
        even = max(even, pixels[k].even);
        dim = max(dim, -pixels[k].even);
        gloss = max(gloss, pixels[k].gloss);
        broad = max(broad, -pixels[k].exponent);
        behind = pixels[k].behind ? 1.0 : behind;
    }
    if (members == 0u) return;
    farRaise3(HIGH, high);
    farRaise3(LOW, low);
    farRaise3(EVEN, even);
    farRaise3(DIM, dim);
    farRaise3(GLOSS, gloss);
    farRaise(BROAD, broad);
    farRaise(BEHIND, behind);
}

// The same, of what is to be known from the centre on.
void farSpreadAround(vec3 centre, uint members, Member pixels[PIXELS])
{
    float radius = -NEVER, normal = -NEVER, above = -NEVER, below = -NEVER, mirror = -NEVER;
    for (int k = 0; k < PIXELS; k++) {
        if ((members >> k & 1u) == 0u) continue;
        float over = dot(pixels[k].normal, pixels[k].point - centre);
        radius = max(radius, distance(pixels[k].point, centre));
        normal = max(normal, -dot(pixels[k].normal, far_axis));
        above = max(above, over);
        below = max(below, -over);
        mirror = max(mirror, -dot(pixels[k].mirror, far_mirror));
    }
    if (members == 0u) return;
    farRaise(RADIUS, radius);
    farRaise(NORMAL, normal);
    farRaise(ABOVE, above);
    farRaise(BELOW, below);
    farRaise(MIRROR, mirror);
}

Group farFindGroup(uint members, Member pixels[PIXELS])
{
    Group group;
    farSpread(members, pixels);
    barrier();
    group.centre = 0.5 * (farBound3(HIGH) - farBound3(LOW));
    farSpreadAround(group.centre, members, pixels);
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
