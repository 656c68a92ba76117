// Bisects what was chosen, or, at first, makes each base a leaf: new corners are displaced, and the deviations of new triangles found.
uniform int bisect_even; // a deviation is that of the worst of its triangles at this depth, or its own

// A point of the base, displaced; in the world.
vec3 bisectMoved(uint base, vec3 weights)
{
    displacePoint(base, weights);
    return (matc_worldFromLocal * vec4(displaced_position, 1.0)).xyz;
}

vec3 bisectWeights(ivec3 weights)
{
    return vec3(weights) / float(BISECT_WHOLE);
}

// The worst part's distance, in the mean square over four points, the middles of its grandchildren, from where they are moved to, to the plane of the triangle. `p` are its corners in the world,
// as they are moved. Where the surface jumps, a plane that is as steep as the jump is near it: a triangle is off by no more than it is wide.
uint bisectDeviates(uint base, uint number, Corners t, mat3 p)
{
    const vec3 points[4] = vec3[4](vec3(2.0, 1.0, 3.0) / 6.0, vec3(4.0, 1.0, 1.0) / 6.0, vec3(1.0, 2.0, 3.0) / 6.0, vec3(1.0, 4.0, 1.0) / 6.0);
    int deeper = max(bisect_even - findMSB(number), 0);
    if (findMSB(number) < bisect_coarse)
        return bisectCode(1e30); // it is bisected whatever it is
    vec3 across = cross(p[1] - p[0], p[2] - p[0]);
    float area = length(across);
    vec3 normal = area > 0.0 ? across / area : vec3(0.0);
    mat3 corners = mat3(bisectWeights(t.a), bisectWeights(t.b), bisectWeights(t.c));
    float most = 0.0;
    for (uint part = 1u << deeper; part < 2u << deeper; part++) {
        vec3 a = vec3(1.0, 0.0, 0.0), b = vec3(0.0, 1.0, 0.0), c = vec3(0.0, 0.0, 1.0);
        for (int bit = deeper - 1; bit >= 0; bit--) {
            vec3 m = (a + b) / 2.0, x = a;
            bool second = (part >> bit & 1u) != 0u;
            a = second ? b : c;
            b = second ? c : x;
            c = m;
        }
        float sum = 0.0;
        for (int i = 0; i < 4; i++) {
            vec3 at = mat3(a, b, c) * points[i];
            vec3 off = bisectMoved(base, corners * at) - p * at;
            float away = area > 0.0 ? dot(off, normal) : length(off);
            sum += away * away;
        }
        most = max(most, sum / 4.0);
    }
    return bisectCode(sqrt(most));
}

uint bisectRow(uint slot, uint corner)
{
    return BISECT_ROW * (3u * slot + corner);
}

void bisectPut(uint at, vec3 three)
{
    bisect_rows[at] = three.x;
    bisect_rows[at + 1u] = three.y;
    bisect_rows[at + 2u] = three.z;
}

// A row of MeshCaptured: the point that was displaced last.
void bisectPutDisplaced(uint at)
{
    bisectPut(at, displaced_position);
    bisectPut(at + 3u, displaced_normal);
    bisect_rows[at + 6u] = displaced_texcoord.x;
    bisect_rows[at + 7u] = displaced_texcoord.y;
    bisectPut(at + 8u, displaced_tangentU);
    bisectPut(at + 11u, displaced_tangentV);
    bisectPut(at + 14u, displaced_base);
}

vec3 bisectWorld(uint at)
{
    return (matc_worldFromLocal * vec4(bisect_rows[at], bisect_rows[at + 1u], bisect_rows[at + 2u], 1.0)).xyz;
}

#ifdef BISECT_BEGIN
uniform int bisect_level; // ranges of triangles of this depth are found; -1: leaves are made of bases

vec3 bisectMoves(uint base, vec3 weights)
{
    vec3 moved = bisectMoved(base, weights);
    return moved - (matc_worldFromLocal * vec4(displaced_base, 1.0)).xyz;
}

// Of points all over it, and its corners; or, what both its children have.
void bisectFindRange(uint base, uint number)
{
    uint at = bisectRangeOf(base, number), children = bisectRangeOf(base, 2u * number);
    vec3 low = vec3(1e30), high = vec3(-1e30);
    if (findMSB(number) < bisect_ranged) {
        for (uint k = 0u; k < 2u; k++) {
            low = min(low, vec3(uvec3(bisect_ranges[children + k].x, bisect_ranges[children + k].x >> 8, bisect_ranges[children + k].x >> 16) & 255u));
            high = max(high, vec3(uvec3(bisect_ranges[children + k].y, bisect_ranges[children + k].y >> 8, bisect_ranges[children + k].y >> 16) & 255u));
        }
    } else {
        const int STEPS = 8;
        Corners t = bisectCorners(base, number);
        for (int i = 0; i <= STEPS; i++)
            for (int k = 0; k <= STEPS - i; k++) {
                vec3 moves = bisectMoves(base, bisectWeights(t.a * i + t.b * k + t.c * (STEPS - i - k)) / float(STEPS));
                low = min(low, moves);
                high = max(high, moves);
            }
        vec3 reach = max(bisect_reach, vec3(1e-30));
        low = clamp(floor((low / reach + 1.0) * 127.5), 0.0, 255.0);
        high = clamp(ceil((high / reach + 1.0) * 127.5), 0.0, 255.0);
    }
    uvec3 l = uvec3(low), h = uvec3(high);
    bisect_ranges[at] = uvec2(l.x | l.y << 8 | l.z << 16, h.x | h.y << 8 | h.z << 16);
}

void main()
{
    uint base = gl_GlobalInvocationID.x;
    if (bisect_level >= 0) {
        uint number = base & (1u << bisect_level) - 1u | 1u << bisect_level;
        base >>= bisect_level;
        if (base < bisect_work[HIGH])
            bisectFindRange(base, number);
        return;
    }
    if (base >= bisect_work[HIGH])
        return;
    Corners t = bisectCorners(base, 1u);
    mat3 p;
    for (int k = 0; k < 3; k++) {
        p[k] = bisectMoved(base, bisectWeights(k == 0 ? t.a : k == 1 ? t.b : t.c));
        bisectPutDisplaced(bisectRow(base, uint(k)));
    }
    bisect_leaves[base] = bisectPack(Leaf(base, 1u, bisectDeviates(base, 1u, t, p), 0u));
}
#else
// A leaf is there: it comes into the table, and is asked.
void bisectMade(uint slot, Leaf leaf, Corners t)
{
    bisect_leaves[slot] = bisectPack(leaf);
    bisect_work[bisectWord(LIST_FLAGS, slot)] = 0u;
    bisectInsert(bisectId(leaf.base, leaf.number), slot);
    if (bisectWants(leaf.base, leaf.number, t, leaf.own))
        bisect_work[bisectWord(LIST_WANTED + 1u - bisect_work[SWAPPED], atomicAdd(bisect_work[WANTED_NEXT], 1u))] = slot;
}

void bisectStage()
{
    uint i = gl_GlobalInvocationID.x, chosen = bisect_work[CHOSEN];
    if (i >= chosen || bisect_work[FULL] != 0u)
        return;
    uint slot = bisect_work[bisectWord(LIST_CHOSEN, i)], free = atomicAdd(bisect_work[FREE], 0xFFFFFFFFu);
    uint place = int(free) > 0 ? bisect_work[bisectWord(LIST_FREE, free - 1u)] : atomicAdd(bisect_work[HIGH], 1u);
    Leaf leaf = bisectLeaf(bisect_leaves[slot]);
    Corners t = bisectCorners(leaf.base, leaf.number);
    ivec3 middle = (t.a + t.b) / 2;
    uint first = bisectRow(slot, 0u), second = bisectRow(place, 0u);
    vec3 a = bisectWorld(first), b = bisectWorld(first + BISECT_ROW), c = bisectWorld(first + 2u * BISECT_ROW);
    for (uint k = 0u; k < BISECT_ROW; k++) { // (a, b, c) to (c, a, m) and (b, c, m)
        float x = bisect_rows[first + k], y = bisect_rows[first + BISECT_ROW + k], z = bisect_rows[first + 2u * BISECT_ROW + k];
        bisect_rows[first + k] = bisect_rows[second + BISECT_ROW + k] = z;
        bisect_rows[first + BISECT_ROW + k] = x;
        bisect_rows[second + k] = y;
    }
    vec3 moved = bisectMoved(leaf.base, bisectWeights(middle));
    bisectPutDisplaced(first + 2u * BISECT_ROW);
    bisectPutDisplaced(second + 2u * BISECT_ROW);
    for (uint child = 0u; child < 2u; child++) { // a loop, so that a driver has the height but once
        bool last = child == 1u;
        Corners made = Corners(last ? t.b : t.c, last ? t.c : t.a, middle);
        uint number = 2u * leaf.number + child,
             own = min(leaf.own, bisectDeviates(leaf.base, number, made, mat3(last ? b : c, last ? c : a, moved)));
        bisectMade(last ? place : slot, Leaf(leaf.base, number, own, last ? leaf.behind : leaf.own), made);
    }
}
#endif
