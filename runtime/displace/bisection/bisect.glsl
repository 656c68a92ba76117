// Adaptive subdivision by longest-edge bisection: each triangle of the mesh, a base, is the root of
// a binary tree of triangles. Definitions that the compute stages share.
//
// A triangle has corners a, b, c; the edge from a to b is bisected at m = (a + b) / 2 into (c, a,
// m) and (b, c, m), which are the children 0 and 1. Triangles are numbered as in a heap: 1 is the
// base, and n has the children 2 n and 2 n + 1. So leaves need no pointers to each other:
//
//  a point with barycentric coordinates (x, y, z) is in child 0 if x > y, with the coordinates (z,
//  x - y, 2 y) there; else in child 1, with (y - x, z, 2 x)
//  (1/2, 1/4, 1/4) -> child 0, (1/4, 1/4, 1/2) -> child 1, (0, 1/2, 1/2): so the point is in
//  triangle 1 -> 2 -> 5
//
// The neighbor of a leaf at an edge is found by such a walk from a point on the other side. If the
// edge is the edge a b of a triangle at some depth, it is also the edge a b of the neighboring
// triangle, or one of the two other edges of that triangle's parent.
//
// A leaf takes 7 bytes: 40 bits for its number and base, 8 for its own deviation, and 8 for the
// deviation of one ancestor: the nearest whose child 0 has the leaf as its last leaf in order.
// Leaves outnumber such ancestors by one. So each bisected triangle stores its deviation in the
// last leaf of its child 0, and no two of them in the same leaf:
//
//  1 is bisected, then 2: leaves 4, 5, 3 store their own deviation, and that of 2, of 1, and none.
//  If 4 and 5 merge into 2, leaf 2 takes 2's deviation as its own from 4, and keeps 1's from 5
#ifdef BISECT_FEW
const uint BISECT_THREADS = 512u;
layout(local_size_x = 512) in;
#else
const uint BISECT_THREADS = 64u;
layout(local_size_x = 64) in;
#endif

// Bases, of BISECT_BASE words each. The first word says which corner is a, and which edges run from
// the later place to the earlier one. Then, per edge, the offset of a word with the beginning of
// the edge's members; the next word has their end. Then corners and their normals in world space. A
// member is 4 base + edge. Edge k is opposite corner k.
layout(std430, binding = 0) readonly buffer BisectBases {
    uint bisect_bases[];
};
// Leaves, four in seven words: the low 32 bits of each leaf's number and base, the high 8 bits of
// all four, and their deviations.
layout(std430, binding = 1) coherent buffer BisectLeaves {
    uint bisect_leaves[];
};
// Hash table of leaves by their numbers: slot plus 1, with the stamp of the table's generation in
// the high bits; entries with another stamp are empty. An entry whose leaf has another number by
// now counts as occupied.
layout(std430, binding = 2) coherent buffer BisectTable {
    uint bisect_table[];
};
// The state block, LIST_DUE lists of a word for each slot, and a float for each tile.
layout(std430, binding = 3) coherent buffer BisectWork {
    uint bisect_work[];
};
// Displaced corners of leaves: rows of MeshCaptured, three for each leaf.
#ifdef BISECT_FEW
coherent
#endif
layout(std430, binding = 4) buffer BisectRows {
    float bisect_rows[];
};
uniform int bisect_capacity;  // capacity in leaves
uniform int bisect_baseBits;  // bits of a base's number
uniform int bisect_tableBits; // log2 of the table's size
// stamp of this evaluation, from 1 to 255: table entries with another stamp are empty
uniform int bisect_stamp;
uniform float bisect_worst; // upper bound of any deviation
uniform int bisect_coarse;  // triangles of smaller depth are always bisected

#include "bisection.layout.def"
const uint BISECT_NONE = 0xFFFFFFFFu;
const int BISECT_WHOLE = 65536; // sum of a corner's weights
// The single workgroup that runs all rounds keeps the state block up to LIGHT in shared memory.
const uint BISECT_COUNTS = LIGHT;
#ifdef BISECT_FEW
shared uint bisect_state[BISECT_COUNTS];
#else
#define bisect_state bisect_work
#endif
#ifdef BISECT_WIDE // evaluating more leaves costs a GPU less than a finer choice
// slots of a tile; tiles per workgroup of the stage that evaluates leaves
const uint BISECT_TILE = BISECT_TILE_MANY, BISECT_LOOK_TILES = 16u;
#else
const uint BISECT_TILE = BISECT_TILE_FEW;
#endif
// Leaves that a workgroup bisects at once. Each needs at least nine heights, one per thread on a
// wide device.
#ifdef BISECT_FEW
const uint BISECT_SPLITS = 128u;
#elif defined(BISECT_WIDE)
const uint BISECT_SPLITS = BISECT_THREADS / 9u;
#else
const uint BISECT_SPLITS = BISECT_THREADS;
#endif
// Flags of a leaf: its parent need not be bisected; it was chosen in this round; it is to be
// bisected; it is in the next round's list of merges. The flags persist from view to view.
const uint FLAG_LESS = 1u, FLAG_CHOSEN = 2u, FLAG_WANTED = 4u, FLAG_ASKED = 8u;

// Makes writes before the call visible before writes after it, to all threads, or to those of the
// only workgroup, which is faster.
void bisectFence()
{
#ifdef BISECT_FEW
    groupMemoryBarrier();
#else
    memoryBarrierBuffer();
    memoryBarrierShared();
#endif
}

// Returns a thread's task, from the workgroup's tasks.
uint bisectTask(uint group)
{
#ifdef BISECT_FEW // neighboring tasks go to different warps: divergent threads run in turn
    const uint STEP = BISECT_THREADS / 32u;
    return BISECT_THREADS * group + gl_LocalInvocationIndex % 32u * STEP +
        gl_LocalInvocationIndex / 32u;
#else
    return BISECT_THREADS * group + gl_LocalInvocationIndex;
#endif
}

uint bisectWord(uint list, uint i)
{
    return STATE_WORDS + list * uint(bisect_capacity) + i;
}

// -- leaves

struct Leaf {
    uint base, number; // number 0: empty slot
    uint own, behind;  // codes of deviations: the leaf's own, and that of an ancestor
};

uvec2 bisectId(uint base, uint number)
{
    return uvec2(number << bisect_baseBits | base, number >> (32 - bisect_baseBits) & 255u);
}

uint bisectBlock(uint slot)
{
    return BISECT_BLOCK_WORDS * (slot >> 2);
}

uvec2 bisectIdAt(uint slot)
{
    uint block = bisectBlock(slot);
    return uvec2(bisect_leaves[block + (slot & 3u)],
        bisect_leaves[block + 4u] >> 8u * (slot & 3u) & 255u);
}

Leaf bisectLeaf(uint slot)
{
    uvec2 id = bisectIdAt(slot);
    uint deviations = bisect_leaves[bisectBlock(slot) + 5u + (slot >> 1 & 1u)] >> 16u * (slot & 1u);
    return Leaf(id.x & (1u << bisect_baseBits) - 1u,
        id.x >> bisect_baseBits | id.y << (32 - bisect_baseBits), deviations & 255u,
                deviations >> 8 & 255u);
}

// Writes bits of a word that no other thread writes.
void bisectPutBits(uint word, uint shift, uint mask, uint value)
{
    uint had = bisect_leaves[word] >> shift & mask;
    if (had != value)
        atomicXor(bisect_leaves[word], (had ^ value) << shift);
}

// Writes a leaf. A concurrent reader gets the old leaf, the new one, or one of a base that does not
// exist.
void bisectPut(uint slot, Leaf l)
{
    uvec2 id = bisectId(l.base, l.number), had = bisectIdAt(slot);
    uint block = bisectBlock(slot), low = block + (slot & 3u);
    if (had.y != id.y) {
        bisect_leaves[low] = BISECT_NONE;
        bisectFence();
        bisectPutBits(block + 4u, 8u * (slot & 3u), 255u, id.y);
        bisectFence();
    }
    bisectPutBits(block + 5u + (slot >> 1 & 1u), 16u * (slot & 1u), 65535u, l.own | l.behind << 8);
    bisect_leaves[low] = id.x;
}

// Replaces a leaf of known value, without the latency of reading it.
void bisectReplace(uint slot, Leaf had, Leaf l)
{
    uvec2 id = bisectId(l.base, l.number);
    uint block = bisectBlock(slot), low = block + (slot & 3u),
        high = bisectId(had.base, had.number).y ^ id.y;
    if (high != 0u) {
        bisect_leaves[low] = BISECT_NONE;
        bisectFence();
        atomicXor(bisect_leaves[block + 4u], high << 8u * (slot & 3u));
        bisectFence();
    }
    atomicXor(bisect_leaves[block + 5u + (slot >> 1 & 1u)],
        ((had.own ^ l.own) | (had.behind ^ l.behind) << 8) << 16u * (slot & 1u));
    bisect_leaves[low] = id.x;
}

// Codes of deviations: logarithmic, 8 per octave below the upper bound; 0 is 0, 255 is above all
// others.
const uint BISECT_ALWAYS = 255u;
uint bisectCode(float deviation)
{
    return deviation > 0.0
        ? uint(clamp(round(8.0 * log2(deviation / bisect_worst)) + 254.0, 1.0, 254.0)) : 0u;
}

float bisectDeviation(uint code)
{
    return code == 0u ? 0.0 : code == BISECT_ALWAYS ? 1e30
        : bisect_worst * exp2((float(code) - 254.0) / 8.0);
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
        at += uint(taken); // a taken entry: go on with the next one
    }
}

// Returns the slot of a leaf; BISECT_NONE: missing.
uint bisectFind(uint base, uint number)
{
    uvec2 id = bisectId(base, number);
    for (uint at = bisectHash(id);; at++) {
        uint entry = bisect_table[at & ((1u << bisect_tableBits) - 1u)],
            slot = (entry & 0xFFFFFFu) - 1u;
        if (entry >> 24 != uint(bisect_stamp))
            return BISECT_NONE;
        if (bisectIdAt(slot) == id)
            return slot;
    }
}

// Returns the slots of both children of a triangle. Both first entries are read at once to hide
// latency; the search continues only where they are other leaves.
uvec2 bisectFindChildren(uint base, uint number)
{
    uvec2 first = bisectId(base, 2u * number), second = bisectId(base, 2u * number + 1u);
    uint most = (1u << bisect_tableBits) - 1u;
    uvec2 entry = uvec2(bisect_table[bisectHash(first) & most],
        bisect_table[bisectHash(second) & most]);
    uvec2 slot = min((entry & 0xFFFFFFu) - 1u, uvec2(bisect_capacity - 1)), there = entry >> 24;
    bool has_first = bisectIdAt(slot.x) == first, has_second = bisectIdAt(slot.y) == second;
    if (there.x != uint(bisect_stamp) || !has_first)
        slot.x = bisectFind(base, 2u * number);
    if (there.y != uint(bisect_stamp) || !has_second)
        slot.y = bisectFind(base, 2u * number + 1u);
    return slot;
}

// -- corners, by their barycentric weights in the base

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
        t = Corners(second ? t.b : t.c, second ? t.c : t.a, t.a + t.b >> 1);
    }
    return t;
}

Corners bisectParent(uint number, Corners t)
{
    bool second = (number & 1u) != 0u;
    ivec3 other = 2 * t.c - (second ? t.a : t.b);
    return Corners(second ? other : t.b, second ? t.a : other, second ? t.b : t.a);
}

// -- neighbors

// The `count` triangles at edge a b of a triangle, with or without the triangle itself.
struct Ring {
    uint first, count; // range of the members; first BISECT_NONE: the edge is inside the base
    int depth;         // depth of the triangles of which this edge is the edge a b
    ivec3 beyond;      // for an edge inside the base: three times a point of the neighbor
    int weight;        // edge not inside the base: sum of both ends' weights at the earlier place
};

uint bisectEdge(Corners t)
{
    for (uint k = 0u; k < 3u; k++)
        if (t.a[k] == 0 && t.b[k] == 0)
            return k;
    return 3u;
}

// Returns the corner of edge k of a base that is the earlier place.
uint bisectEarlier(uint base, uint k)
{
    return (k + 1u + (bisect_bases[BISECT_BASE * base] >> (2u + k) & 1u)) % 3u;
}

// Returns 1 unless the edge is the one that is bisected first.
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
    return Ring(first, bisect_bases[start + 1u] - first, depth - bisectLater(base, k), ivec3(0),
        t.a[earlier] + t.b[earlier]);
}

// Finds member i of the ring, at the depth at which the ring's edge is its edge a b.
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
