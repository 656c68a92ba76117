// Bisectors: triangles that a triangle of the mesh, its base, is bisected into. What its compute stages share.
//
// A triangle has corners a, b, c; the edge from a to b is bisected, at m = (a + b) / 2, into (c, a, m) and (b, c, m), which are its children 0 and 1. A number says which it is: 1 is a base,
// and n has the children 2 n and 2 n + 1. So the leaves that there are need no pointers to each other:
//
//     a point that is (x, y, z) of the corners is in child 0 if x > y, and (z, x - y, 2 y) of its; else in child 1, and (y - x, z, 2 x) of its
//     (1/2, 1/4, 1/4) -> child 0, (1/4, 1/4, 1/2) -> child 1, (0, 1/2, 1/2): so the point is in triangle 1 -> 2 -> 5
//
// Which leaf is beyond an edge is what such a walk ends at, from a point beyond it: an edge that is a triangle's edge from a to b at some depth is that of the one beyond as well,
// or one of the other two of that one's parent.
//
// A leaf is 8 bytes: 40 bits of its number and base, 12 of its own deviation, and 12 of the deviation of the triangle behind it, in order: the nearest of those it is in whose child 0 has it,
// as its last leaf. There are as many as leaves, but one. So each triangle that was bisected has its deviation in the last leaf of its child 0, and nobody else's in the same place:
//
//     1 is bisected, then 2: leaves 4, 5, 3 keep their own and 2's, 1's, none's. If 4 and 5 become 2, that has 2's, as its own, from 4, and keeps 1's, from 5
layout(local_size_x = 64) in;

// Of a base BISECT_BASE words: which corner is its a, and which of its edges run from the later place to the earlier one; by edge where its word is, which says where its members begin, as the
// next word does where they end; corners and their normals in the world. A member is 4 base + edge. Edge k is opposite corner k.
layout(std430, binding = 0) readonly buffer BisectBases {
    uint bisect_bases[];
};
layout(std430, binding = 1) buffer BisectLeaves {
    uvec2 bisect_leaves[];
};
// Places of leaves by a hash of their numbers, plus 1, below the stamp of the look that they are of: others are empty. An entry whose leaf has another number by now counts as one that is taken.
layout(std430, binding = 2) coherent buffer BisectTable {
    uint bisect_table[];
};
// A head, and lists of BISECT_LISTS times as many words as there is room for leaves.
layout(std430, binding = 3) coherent buffer BisectWork {
    uint bisect_work[];
};
// Corners of leaves, displaced: rows of MeshCaptured, three for each.
layout(std430, binding = 4) buffer BisectRows {
    float bisect_rows[];
};
// How far points move, along the world's axes, at least and at most, in bytes of which 0 is -bisect_reach and 255 bisect_reach: of triangles of each depth up to bisect_ranged, of
// a deeper one as of the one there that it is in.
layout(std430, binding = 5) buffer BisectRanges {
    uvec2 bisect_ranges[];
};
uniform int bisect_ranged;
uniform int bisect_room;        // for leaves
uniform int bisect_baseBits;    // that a number of a base has
uniform int bisect_tableBits;   // it has 2 to the power of that entries
uniform int bisect_stamp;       // 1 to 255
uniform int bisect_deepest;     // no triangle is bisected for its own sake from there on
uniform int bisect_coarse;      // triangles of less depth are bisected, whatever they deviate
uniform vec3 bisect_reach;      // along the world's axes, no point moves farther
uniform vec4 bisect_eye;        // and 1; or where rays come from, and 0
uniform mat4 bisect_sides;      // of what is seen, by columns: a point is beyond one where the product is negative
uniform vec4 bisect_front;      // the same
uniform float bisect_near;      // what is nearer counts as so far
uniform float bisect_scale;     // pixels of a unit, at a distance of 1
uniform float bisect_pixels;    // that a deviation may have
uniform float bisect_closed;    // 1: nobody sees its triangles from behind

const uint BISECT_BASE = 22u, BISECT_ROW = 17u, BISECT_HEAD = 98u, BISECT_NONE = 0xFFFFFFFFu;
const int BISECT_WHOLE = 65536; // weights of a corner sum up to so many
// Words of the head.
const uint HIGH = 0u, FREE = 1u, WANTED = 2u, WANTED_NEXT = 3u, MERGING = 4u, MERGING_NEXT = 5u, CHOSEN = 6u, FULL = 7u, SPLITS = 8u, MERGES = 9u,
           SWAPPED = 10u, MERGED_ALL = 11u, LOST = 12u, MERGE_ROUNDS = 13u, SPLIT_ROUNDS = 14u, DONE = 15u, GROUPS = 16u, GROUPS_CHOSEN = 20u, LIGHTS = 24u, LIGHT = 28u, BOX = 92u;
// Lists.
const uint LIST_FREE = 0u, LIST_FLAGS = 1u, LIST_CHOSEN = 2u, LIST_WANTED = 3u, LIST_MERGING = 5u;
// Flags of a leaf: its parent may be one, it is to be bisected, it became its parent, it is in the list of those that are asked next.
const uint FLAG_LESS = 1u, FLAG_CHOSEN = 2u, FLAG_MERGED = 4u, FLAG_ASKED = 8u;

uint bisectWord(uint list, uint i)
{
    return BISECT_HEAD + list * uint(bisect_room) + i;
}

// -- leaves

struct Leaf {
    uint base, number; // number 0: none
    uint own, behind;  // deviations, as codes
};

uvec2 bisectId(uint base, uint number)
{
    return uvec2(number << bisect_baseBits | base, number >> (32 - bisect_baseBits) & 255u);
}

uvec2 bisectPack(Leaf l)
{
    return bisectId(l.base, l.number) | uvec2(0u, l.own << 8 | l.behind << 20);
}

Leaf bisectLeaf(uvec2 bits)
{
    return Leaf(bits.x & (1u << bisect_baseBits) - 1u, bits.x >> bisect_baseBits | (bits.y & 255u) << (32 - bisect_baseBits),
                bits.y >> 8 & 4095u, bits.y >> 20);
}

// 32 codes an octave; 0 is 0, 2048 is 1.
uint bisectCode(float deviation)
{
    return deviation > 0.0 ? uint(clamp(round(32.0 * log2(deviation)) + 2048.0, 1.0, 4094.0)) : 0u;
}

float bisectDeviation(uint code)
{
    return code == 0u ? 0.0 : exp2((float(code) - 2048.0) / 32.0);
}

uint bisectHash(uvec2 id)
{
    uint h = (id.x ^ id.y * 0x9E3779B1u) * 0x85EBCA77u;
    return (h ^ h >> 15) * 0xC2B2AE3Du >> 3;
}

void bisectInsert(uvec2 id, uint slot)
{
    uint entry = uint(bisect_stamp) << 24 | (slot + 1u), at = bisectHash(id);
    for (bool done = false; !done;) {
        uint place = at & ((1u << bisect_tableBits) - 1u), had = bisect_table[place];
        bool taken = had >> 24 == uint(bisect_stamp);
        done = !taken && atomicCompSwap(bisect_table[place], had, entry) == had;
        at += uint(taken); // who came before in the meantime is read next
    }
}

// Where that leaf is; BISECT_NONE: there is none.
uint bisectFind(uint base, uint number)
{
    uvec2 id = bisectId(base, number);
    for (uint at = bisectHash(id);; at++) {
        uint entry = bisect_table[at & ((1u << bisect_tableBits) - 1u)], slot = (entry & 0xFFFFFFu) - 1u;
        if (entry >> 24 != uint(bisect_stamp))
            return BISECT_NONE;
        uvec2 bits = bisect_leaves[slot];
        if (bits.x == id.x && (bits.y & 255u) == id.y)
            return slot;
    }
}

// -- corners, by their weights in the base

struct Corners {
    ivec3 a, b, c;
};

uint bisectFirst(uint base)
{
    return bisect_bases[BISECT_BASE * base] & 3u;
}

ivec3 bisectUnit(uint corner)
{
    return ivec3(corner % 3u == 0u, corner % 3u == 1u, corner % 3u == 2u) * BISECT_WHOLE;
}

Corners bisectCorners(uint base, uint number)
{
    uint first = bisectFirst(base);
    Corners t = Corners(bisectUnit(first), bisectUnit(first + 1u), bisectUnit(first + 2u));
    for (int bit = findMSB(number) - 1; bit >= 0; bit--) {
        bool second = (number >> bit & 1u) != 0u;
        t = Corners(second ? t.b : t.c, second ? t.c : t.a, (t.a + t.b) / 2);
    }
    return t;
}

Corners bisectParent(uint number, Corners t)
{
    bool second = (number & 1u) != 0u;
    ivec3 other = 2 * t.c - (second ? t.a : t.b);
    return Corners(second ? other : t.b, second ? t.a : other, second ? t.b : t.a);
}

// -- what is seen of it

vec3 bisectMixed(uint base, uint part, ivec3 weights)
{
    uint at = BISECT_BASE * base + 4u + 9u * part;
    vec3 w = vec3(weights) / float(BISECT_WHOLE);
    vec3 sum = vec3(0.0);
    for (uint k = 0u; k < 3u; k++)
        sum += w[k] * vec3(uintBitsToFloat(bisect_bases[at + 3u * k]), uintBitsToFloat(bisect_bases[at + 3u * k + 1u]),
                           uintBitsToFloat(bisect_bases[at + 3u * k + 2u]));
    return sum;
}

uint bisectRangeOf(uint base, uint number)
{
    return (base << (bisect_ranged + 1)) + (number >> max(findMSB(number) - bisect_ranged, 0));
}

vec3 bisectOffset(uint bytes)
{
    return (vec3(uvec3(bytes, bytes >> 8, bytes >> 16) & 255u) / 127.5 - 1.0) * bisect_reach;
}

bool bisectBeyond(vec4 side, vec3 middle, vec3 extent)
{
    return dot(side.xyz, middle) + side.w + dot(abs(side.xyz), extent) < 0.0;
}

// The corner's normal looks away from the eye, or a light, from wherever in the box.
bool bisectAway(uint base, ivec3 corner, vec4 eye, vec3 middle, vec3 extent)
{
    vec3 normal = bisectMixed(base, 1u, corner);
    return dot(normal, eye.xyz - middle * eye.w) + dot(abs(normal), extent) * eye.w < 0.0;
}

bool bisectAllAway(uint base, Corners t, vec4 eye, vec3 middle, vec3 extent)
{
    return bisectAway(base, t.a, eye, middle, extent) && bisectAway(base, t.b, eye, middle, extent) &&
           bisectAway(base, t.c, eye, middle, extent);
}

// -- what is seen of its shadow

vec4 bisectHeadFloats(uint at)
{
    return uintBitsToFloat(uvec4(bisect_work[at], bisect_work[at + 1u], bisect_work[at + 2u], bisect_work[at + 3u]));
}

// How far rays by the box go on until no point of them is where shadows may fall: as a length, or as times what they have gone. A light is a point and 1, or where its rays come from, and 0.
float bisectLightReach(vec4 light, vec3 middle, vec3 extent)
{
    vec3 low = bisectHeadFloats(BOX).xyz, high = bisectHeadFloats(BOX + 3u).xyz;
    float reach = 1e30;
    for (int k = 0; k < 3; k++) {
        float from = light.w != 0.0 ? light[k] : 0.0, least = middle[k] - extent[k] - from, most = middle[k] + extent[k] - from;
        if (light.w == 0.0 ? light[k] < 0.0 : least > 0.0)
            reach = min(reach, light.w == 0.0 ? (least - high[k]) / light[k] : (high[k] - from) / least);
        if (light.w == 0.0 ? light[k] > 0.0 : most < 0.0)
            reach = min(reach, light.w == 0.0 ? (most - low[k]) / light[k] : (low[k] - from) / most);
    }
    return max(reach, light.w);
}

// The box, and all that its shadow may fall on, are beyond the side.
bool bisectCastsBeyond(vec4 side, vec4 light, float reach, vec3 middle, vec3 extent)
{
    float most = dot(side.xyz, middle) + side.w + dot(abs(side.xyz), extent), from = dot(side, light);
    return most < 0.0 && (light.w != 0.0 ? from + reach * (most - from) : most - reach * from) < 0.0;
}

// From a point, to the nearest of the box around 0.
vec3 bisectGap(vec3 at, vec3 extent)
{
    return at - clamp(at, -extent, extent);
}

// How far the box is from the line from the eye towards the light, as long as `last` says: the square grows along that line as a parabola between places where it passes a side of the box, so that its
// slope is a line there.
float bisectLightFar(vec4 light, float last, vec3 middle, vec3 extent)
{
    vec3 from = bisect_eye.xyz - middle, way = light.xyz - bisect_eye.xyz * light.w;
    float low = 0.0, high = last, low_slope = dot(bisectGap(from, extent), way), high_slope = dot(bisectGap(from + last * way, extent), way);
    if (low_slope >= 0.0)
        return length(bisectGap(from, extent));
    if (high_slope <= 0.0)
        return length(bisectGap(from + last * way, extent));
    for (int i = 0; i < 6; i++) {
        int lane = i >> 1;
        float at = ((i & 1) != 0 ? -extent[lane] - from[lane] : extent[lane] - from[lane]) / way[lane];
        if (way[lane] == 0.0 || at <= low || at >= high)
            continue;
        float slope = dot(bisectGap(from + at * way, extent), way);
        low_slope = slope < 0.0 ? slope : low_slope;
        high_slope = slope < 0.0 ? high_slope : slope;
        low = slope < 0.0 ? at : low;
        high = slope < 0.0 ? high : at;
    }
    return length(bisectGap(from + (low + (high - low) * low_slope / (low_slope - high_slope)) * way, extent));
}

// As far as its shadow by any light counts, or as it did before. A deviation e of p, at right angles to the light's ray, is t e in the shadow, where the ray has gone from l to l + t (p - l), and is seen
// t e / |l + t (p - l) - eye| large: that is e / |p - (l + (eye - l) / t)|, and the latter between light and eye, wherever the shadow falls; no nearer to the light than where t is the most that a shadow can have.
float bisectShadowFar(uint base, Corners t, float before, vec3 middle, vec3 extent)
{
    for (uint i = 0u; i < bisect_work[LIGHTS]; i++) {
        vec4 light = bisectHeadFloats(LIGHT + 4u * i);
        float reach = bisectLightReach(light, middle, extent);
        bool hidden = bisectCastsBeyond(bisect_front, light, reach, middle, extent);
        for (int side = 0; side < 4; side++)
            hidden = hidden || bisectCastsBeyond(bisect_sides[side], light, reach, middle, extent);
        if (bisect_closed != 0.0 && !hidden)
            hidden = bisectAllAway(base, t, light, middle, extent);
        float last = light.w != 0.0 ? 1.0 - 1.0 / reach : reach;
        if (!hidden)
            before = min(before, bisect_eye.w == 0.0 ? 1.0 : max(bisectLightFar(light, last, middle, extent), bisect_near));
    }
    return before;
}

// Its deviation is too large, as large as it can be seen from anywhere in a box around its points. A child's box is within that of its parent, and its deviation is at most its parent's: so who is not to be
// bisected has no children that are. Out of view, or from behind, it counts as eight times as far, since it is seen in mirrors; but where its shadow may be in view, as that needs it.
bool bisectWants(uint base, uint number, Corners t, uint code)
{
    int depth = findMSB(number);
    if (depth < bisect_coarse || depth >= bisect_deepest)
        return depth < bisect_coarse;
    vec3 a = bisectMixed(base, 0u, t.a), b = bisectMixed(base, 0u, t.b), c = bisectMixed(base, 0u, t.c);
    uvec2 range = bisect_ranges[bisectRangeOf(base, number)];
    vec3 low = min(min(a, b), c) + bisectOffset(range.x), high = max(max(a, b), c) + bisectOffset(range.y),
         middle = (low + high) / 2.0, extent = (high - low) / 2.0;
    bool hidden = bisectBeyond(bisect_front, middle, extent);
    for (int i = 0; i < 4; i++)
        hidden = hidden || bisectBeyond(bisect_sides[i], middle, extent);
    if (bisect_closed != 0.0 && !hidden)
        hidden = bisectAllAway(base, t, bisect_eye, middle, extent);
    float far = bisect_eye.w == 0.0 ? 1.0 : max(length(max(abs(bisect_eye.xyz - middle) - extent, 0.0)), bisect_near);
    far *= hidden ? 8.0 : 1.0;
#ifdef BISECT_LIGHTS
    far = bisectShadowFar(base, t, far, middle, extent);
#endif
    return bisectDeviation(code) * bisect_scale > bisect_pixels * far;
}

// -- neighbours

// Of the triangles at edge a b of one, which are `count`, itself among them or not.
struct Ring {
    uint first, count; // members; first BISECT_NONE: the edge is within the base
    int depth;         // of who has it as its edge a b
    ivec3 beyond;      // within the base: three times a point of that one
    int weight;        // else the sum of both ends' weights at the earlier place
};

uint bisectEdge(Corners t)
{
    for (uint k = 0u; k < 3u; k++)
        if (t.a[k] == 0 && t.b[k] == 0)
            return k;
    return 3u;
}

// The corner of edge k of a base that is the earlier place.
uint bisectEarlier(uint base, uint k)
{
    return (k + 1u + (bisect_bases[BISECT_BASE * base] >> (2u + k) & 1u)) % 3u;
}

// 1 where that edge is not the one that is bisected first.
int bisectLater(uint base, uint k)
{
    return (bisectFirst(base) + 2u) % 3u == k ? 0 : 1;
}

Ring bisectRing(uint base, uint number, Corners t)
{
    uint k = bisectEdge(t);
    int depth = findMSB(number);
    if (k == 3u)
        return Ring(BISECT_NONE, 1u, depth, 2 * (t.a + t.b) - t.c, 0);
    uint start = bisect_bases[BISECT_BASE * base + 1u + k], earlier = bisectEarlier(base, k);
    uint first = bisect_bases[start];
    return Ring(first, bisect_bases[start + 1u] - first, depth - bisectLater(base, k), ivec3(0), t.a[earlier] + t.b[earlier]);
}

// Member i of the ring, at the depth at which it has that edge as its edge a b.
void bisectMember(Ring ring, uint i, inout uint base, out uint number)
{
    ivec3 at = ring.beyond;
    int depth = ring.depth;
    if (ring.first != BISECT_NONE) {
        uint member = bisect_bases[ring.first + i], k = member & 3u;
        base = member >> 2;
        uint earlier = bisectEarlier(base, k);
        at = ivec3(0);
        at[earlier] = ring.weight;
        at[3u - k - earlier] = 2 * BISECT_WHOLE - ring.weight;
        depth += bisectLater(base, k);
    }
    uint first = bisectFirst(base);
    ivec3 w = ivec3(at[first], at[(first + 1u) % 3u], at[(first + 2u) % 3u]);
    number = 1u;
    for (int i = 0; i < depth; i++) {
        bool second = w.x <= w.y;
        number = 2u * number + uint(second);
        w = second ? ivec3(w.y - w.x, w.z, 2 * w.x) : ivec3(w.z, w.x - w.y, 2 * w.y);
    }
}
