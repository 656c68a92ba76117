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

// Of a triangle's points, the four that are asked how far they are from its plane: the middles of its grandchildren.
const vec3 bisect_asked[4] = vec3[4](vec3(2.0, 1.0, 3.0) / 6.0, vec3(4.0, 1.0, 1.0) / 6.0, vec3(1.0, 2.0, 3.0) / 6.0, vec3(1.0, 4.0, 1.0) / 6.0);

// How much deeper than the triangle its parts are: the worst of them counts; 0 where it is bisected whatever it is.
int bisectDeeper(uint number)
{
    int depth = findMSB(number);
    return depth < bisect_coarse ? 0 : max(bisect_even - depth, 0);
}

// The corners of a part, by the triangle's; which part it is is said as numbers of triangles say it, from 1 << deeper on.
mat3 bisectPartOf(uint part, int deeper)
{
    vec3 a = vec3(1.0, 0.0, 0.0), b = vec3(0.0, 1.0, 0.0), c = vec3(0.0, 0.0, 1.0);
    for (int bit = deeper - 1; bit >= 0; bit--) {
        vec3 m = (a + b) / 2.0, x = a;
        bool second = (part >> bit & 1u) != 0u;
        a = second ? b : c;
        b = second ? c : x;
        c = m;
    }
    return mat3(a, b, c);
}

mat3 bisectWeightsOf(Corners t)
{
    return mat3(bisectWeights(t.a), bisectWeights(t.b), bisectWeights(t.c));
}

// The square of how far it is from the plane of a triangle, whose corners are `p`, at whose point it would be. Where that has no area, it is from the point.
float bisectSquare(vec3 moved, vec3 at, mat3 p)
{
    vec3 across = cross(p[1] - p[0], p[2] - p[0]), off = moved - p * at;
    float area = length(across), away = area > 0.0 ? dot(off, across / area) : length(off);
    return away * away;
}

// A triangle's error, from the mean square of its worst part. Where the surface jumps, a plane that is as steep as the jump is near it: a triangle is off by no more than it is wide.
uint bisectError(uint number, float square)
{
    return findMSB(number) < bisect_coarse ? BISECT_ALWAYS : bisectCode(sqrt(square));
}

uint bisectRow(uint slot, uint corner)
{
    return BISECT_ROW * (3u * slot + corner);
}

void bisectPutThree(uint at, vec3 three)
{
    bisect_rows[at] = three.x;
    bisect_rows[at + 1u] = three.y;
    bisect_rows[at + 2u] = three.z;
}

// A row of MeshCaptured: the point that was displaced last.
void bisectPutDisplaced(uint at)
{
    bisectPutThree(at, displaced_position);
    bisectPutThree(at + 3u, displaced_normal);
    bisect_rows[at + 6u] = displaced_texcoord.x;
    bisect_rows[at + 7u] = displaced_texcoord.y;
    bisectPutThree(at + 8u, displaced_tangentU);
    bisectPutThree(at + 11u, displaced_tangentV);
    bisectPutThree(at + 14u, displaced_base);
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
    int deeper = bisectDeeper(1u);
    float most = 0.0;
    for (uint part = 1u << deeper; part < 2u << deeper; part++) {
        float sum = 0.0;
        for (int i = 0; i < 4; i++) {
            vec3 at = bisectPartOf(part, deeper) * bisect_asked[i];
            sum += bisectSquare(bisectMoved(base, bisectWeightsOf(t) * at), at, p);
        }
        most = max(most, sum / 4.0);
    }
    bisectPut(base, Leaf(base, 1u, bisectError(1u, most), 0u));
}
#else
// A leaf is there: it comes into the table, and is asked.
void bisectMade(BisectBase base, uint slot, Leaf leaf, Corners t, float parent)
{
    float own = bisectWants(base, leaf.base, leaf.number, t, leaf.own);
    bisectPut(slot, leaf);
    bisect_work[bisectWord(LIST_FLAGS, slot)] = own > 0.0 ? FLAG_WANTED : parent <= 0.0 ? FLAG_LESS : 0u;
    bisectInsert(bisectId(leaf.base, leaf.number), slot);
    bisectDue(slot, min(abs(own), abs(parent)));
    if (own > 0.0)
        bisect_work[bisectWord(LIST_WANTED + 1u - bisect_work[SWAPPED], atomicAdd(bisect_work[WANTED_NEXT], 1u))] = slot;
}

// Points of one that is bisected: the middle, four in each child, and its corners as they were.
const uint SPLIT_MIDDLE = 0u, SPLIT_ASKED = 1u, SPLIT_CORNERS = 9u, SPLIT_POINTS = 12u;
shared vec3 split_points[SPLIT_POINTS * BISECT_SPLITS];
shared float split_worst[2u * BISECT_SPLITS]; // of children that count as their worst part
shared uint split_places[BISECT_SPLITS];

Corners bisectChild(Corners t, uint child)
{
    return Corners(child == 0u ? t.c : t.b, child == 0u ? t.a : t.c, (t.a + t.b) / 2);
}

mat3 bisectChildPoints(uint at, uint child)
{
    return mat3(split_points[at + SPLIT_CORNERS + 2u - child], split_points[at + SPLIT_CORNERS + 2u * child], split_points[at + SPLIT_MIDDLE]);
}

// (a, b, c) becomes (c, a, m) and (b, c, m): rows of all but m, and the corners' points.
void bisectCopyRows(uint slot, uint place, uint points)
{
    uint first = bisectRow(slot, 0u), second = bisectRow(place, 0u);
    for (uint k = 0u; k < 3u; k++)
        split_points[points + SPLIT_CORNERS + k] = bisectWorld(first + k * BISECT_ROW);
    for (uint k = 0u; k < BISECT_ROW; k++) {
        float x = bisect_rows[first + k], y = bisect_rows[first + BISECT_ROW + k], z = bisect_rows[first + 2u * BISECT_ROW + k];
        bisect_rows[first + k] = bisect_rows[second + BISECT_ROW + k] = z;
        bisect_rows[first + BISECT_ROW + k] = x;
        bisect_rows[second + k] = y;
    }
}

// Displaces points of it: the middle, whose rows are written, and what both children are asked at. Where these count as their worst parts, one thread asks all of them.
void bisectDisplace(uint lane, uint at, uint slot, uint place, Leaf leaf, Corners t)
{
    int deeper = bisectDeeper(2u * leaf.number);
    uint parts = 1u << deeper, count = deeper == 0 ? SPLIT_CORNERS : lane == 0u ? 1u + 8u * parts : 0u;
    float sum = 0.0, most = 0.0;
    for (uint point = lane; point < count; point += deeper == 0 ? BISECT_LANES : 1u) { // a driver has the height but once
        uint asked = point - 1u, child = asked / (4u * parts);
        vec3 inside = bisectPartOf(asked / 4u % parts | parts, deeper) * bisect_asked[asked % 4u];
        vec3 moved = bisectMoved(leaf.base, point == 0u ? bisectWeights((t.a + t.b) / 2) : bisectWeightsOf(bisectChild(t, child)) * inside);
        if (point == 0u) {
            bisectPutDisplaced(bisectRow(slot, 2u));
            bisectPutDisplaced(bisectRow(place, 2u));
        }
        if (point == 0u || deeper == 0) {
            split_points[at + point] = moved;
            continue;
        }
        sum = asked % 4u == 0u ? 0.0 : sum;
        sum += bisectSquare(moved, inside, bisectChildPoints(at, child));
        most = asked % (4u * parts) < 4u ? 0.0 : most;
        most = max(most, asked % 4u == 3u ? sum / 4.0 : 0.0);
        split_worst[at / SPLIT_POINTS * 2u + child] = most;
    }
}

void bisectMakeChild(uint child, uint at, uint slot, Leaf leaf, Corners t)
{
    uint number = 2u * leaf.number + child;
    mat3 p = bisectChildPoints(at, child);
    float square = 0.0;
    for (int i = 0; i < 4; i++)
        square += bisectSquare(split_points[at + SPLIT_ASKED + 4u * child + uint(i)], bisect_asked[i], p) / 4.0;
    if (bisectDeeper(number) > 0)
        square = split_worst[at / SPLIT_POINTS * 2u + child];
    BisectBase base = bisectBase(leaf.base);
    float wants = child == 0u ? bisectWants(base, leaf.base, leaf.number, t, leaf.own) : BISECT_SURE; // or one of its ring does
    Leaf made = Leaf(leaf.base, number, min(leaf.own, bisectError(number, square)), child == 0u ? leaf.own : leaf.behind);
    bisectMade(base, slot, made, bisectChild(t, child), wants);
}

void bisectStage(uint group)
{
    uint lane = gl_LocalInvocationIndex % BISECT_LANES, local = gl_LocalInvocationIndex / BISECT_LANES, i = BISECT_SPLITS * group + local,
         at = SPLIT_POINTS * local, slot = 0u, place = 0u;
#ifdef BISECT_WIDE
    barrier(); // those that the group bisected before are made
#endif
    bool there = local < BISECT_SPLITS && i < bisect_work[CHOSEN] && bisect_work[FULL] == 0u;
    Leaf leaf;
    Corners t;
    if (there) {
        slot = bisect_work[bisectWord(LIST_CHOSEN, i)];
        leaf = bisectLeaf(slot);
        t = bisectCorners(leaf.base, leaf.number);
        if (lane == 0u) {
            uint free = atomicAdd(bisect_work[FREE], 0xFFFFFFFFu);
            place = int(free) > 0 ? bisect_work[bisectWord(LIST_FREE, free - 1u)] : atomicAdd(bisect_work[HIGH], 1u);
            split_places[local] = place;
            bisectCopyRows(slot, place, at);
        }
        bisectDisplace(lane, at, slot, place, leaf, t);
    }
#ifdef BISECT_WIDE
    memoryBarrierShared();
    barrier();
#endif
    if (there)
        for (uint child = lane; child < 2u; child += BISECT_LANES)
            bisectMakeChild(child, at, child == 0u ? slot : split_places[local], leaf, t);
}
#endif
