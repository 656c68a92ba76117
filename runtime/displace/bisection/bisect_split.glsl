// Bisects the chosen leaves, or initially makes each base a leaf: displaces new corners, and
// computes the deviations of new triangles.
// a deviation is the maximum over a triangle's descendants at this depth, or its own if deeper
uniform int bisect_even;

// Returns a displaced point of the base, in world space.
vec3 bisectMoved(uint base, vec3 weights)
{
    displacePoint(base, weights);
    return (matc_worldFromLocal * vec4(displaced_position, 1.0)).xyz;
}

vec3 bisectWeights(ivec3 weights)
{
    return vec3(weights) / float(BISECT_WHOLE);
}

// Barycentric coordinates at which a triangle's distance from the surface is evaluated: the centers
// of its grandchildren.
const vec3 bisect_asked[4] = vec3[4](vec3(2.0, 1.0, 3.0) / 6.0, vec3(4.0, 1.0, 1.0) / 6.0,
    vec3(1.0, 2.0, 3.0) / 6.0, vec3(1.0, 4.0, 1.0) / 6.0);

// Returns the number of levels below the triangle at which its parts are evaluated, of which the
// worst counts; 0 if it is bisected in any case.
int bisectDeeper(uint number)
{
    int depth = findMSB(number);
    return depth < bisect_coarse ? 0 : max(bisect_even - depth, 0);
}

// Returns the corners of a part, in the triangle's barycentric coordinates; parts are numbered like
// triangles in the tree, from 1 << deeper on.
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

// Returns the squared distance of a displaced point from the plane of a triangle with corners `p`;
// of a degenerate triangle from its point with the coordinates `at`.
float bisectSquare(vec3 moved, vec3 at, mat3 p)
{
    vec3 across = cross(p[1] - p[0], p[2] - p[0]), off = moved - p * at;
    float area = length(across), away = area > 0.0 ? dot(off, across / area) : length(off);
    return away * away;
}

// Returns the code of a triangle's deviation, from the mean square of its worst part. Near a
// discontinuity of the surface a plane as steep as the jump is close to it: the triangle deviates
// by at most its own width.
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

// Writes the last displaced point as a row of MeshCaptured.
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
    return (matc_worldFromLocal * vec4(bisect_rows[at], bisect_rows[at + 1u], bisect_rows[at + 2u],
        1.0)).xyz;
}

#ifdef BISECT_BEGIN
uniform int bisect_level; // depth of triangles whose ranges are computed; -1: make leaves of bases

vec3 bisectMoves(uint base, vec3 weights)
{
    vec3 moved = bisectMoved(base, weights);
    return moved - (matc_worldFromLocal * vec4(displaced_base, 1.0)).xyz;
}

// Finds the range of the displacement over a triangle and its corners; or the union of both
// children's ranges.
void bisectFindRange(uint base, uint number)
{
    uint at = bisectRangeOf(base, number), children = bisectRangeOf(base, 2u * number);
    vec3 low = vec3(1e30), high = vec3(-1e30);
    if (findMSB(number) < bisect_ranged) {
        for (uint k = 0u; k < 2u; k++) {
            low = min(low,
                vec3(uvec3(bisect_ranges[children + k].x, bisect_ranges[children + k].x >> 8,
                bisect_ranges[children + k].x >> 16) & 255u));
            high = max(high,
                vec3(uvec3(bisect_ranges[children + k].y, bisect_ranges[children + k].y >> 8,
                bisect_ranges[children + k].y >> 16) & 255u));
        }
    } else {
        const int STEPS = 8;
        Corners t = bisectCorners(base, number);
        for (int i = 0; i <= STEPS; i++)
            for (int k = 0; k <= STEPS - i; k++) {
                vec3 moves = bisectMoves(base,
                    bisectWeights(t.a * i + t.b * k + t.c * (STEPS - i - k)) / float(STEPS));
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
        if (base < bisect_state[HIGH])
            bisectFindRange(base, number);
        return;
    }
    if (base >= bisect_state[HIGH])
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
// Leaves that a workgroup bisects: the slots of both children, the previous leaf, its corners,
// their displaced positions and the midpoint's; and the mean square of each child's worst part, as
// a word: nonnegative floats are ordered like their bit patterns.
struct Split {
    uint slot, place;
    Leaf leaf;
    int deeper; // number of levels of a child's parts below the child
    Corners t;
    vec3 corners[3], middle;
    uint worst[2];
};
shared Split splits[BISECT_SPLITS];
shared uint split_first[BISECT_SPLITS + 1u]; // prefix sum of the evaluated points
shared float split_squares[BISECT_THREADS];

Corners bisectChild(Corners t, uint child)
{
    return Corners(child == 0u ? t.c : t.b, child == 0u ? t.a : t.c, (t.a + t.b) / 2);
}

mat3 bisectChildPoints(uint local, uint child)
{
    return mat3(splits[local].corners[2u - child], splits[local].corners[2u * child],
        splits[local].middle);
}

void bisectPrepare(uint local, uint slot)
{
    Leaf leaf = bisectLeaf(slot);
    uint free = atomicAdd(bisect_state[FREE], 0xFFFFFFFFu);
    splits[local].slot = slot;
    splits[local].place = int(free) > 0 ? bisect_work[bisectWord(LIST_FREE, free - 1u)]
        : atomicAdd(bisect_state[HIGH], 1u);
    splits[local].leaf = leaf;
    splits[local].deeper = bisectDeeper(2u * leaf.number);
    splits[local].t = bisectCorners(leaf.base, leaf.number);
    splits[local].worst[0] = splits[local].worst[1] = 0u;
    for (uint k = 0u; k < 3u; k++)
        splits[local].corners[k] = bisectWorld(bisectRow(slot, k));
}

// Copies a column of the rows of all corners but m: (a, b, c) becomes (c, a, m) and (b, c, m).
void bisectCopyRows(uint local, uint k)
{
    uint first = bisectRow(splits[local].slot, 0u) + k,
        second = bisectRow(splits[local].place, 0u) + k;
    float x = bisect_rows[first], y = bisect_rows[first + BISECT_ROW],
        z = bisect_rows[first + 2u * BISECT_ROW];
    bisect_rows[first] = bisect_rows[second + BISECT_ROW] = z;
    bisect_rows[first + BISECT_ROW] = x;
    bisect_rows[second] = y;
}

// Displaces one point: the midpoint, whose rows are written, or one of the points at which the
// children are evaluated, four of each part of each child; `within` is the point in its child's
// coordinates.
vec3 bisectPoint(uint local, bool middle, uint at, out vec3 within)
{
    int deeper = splits[local].deeper;
    uint part = at >> 2 & (1u << deeper) - 1u | 1u << deeper;
    within = bisectPartOf(part, deeper) * bisect_asked[at & 3u];
    vec3 moved = bisectMoved(splits[local].leaf.base,
        middle ? bisectWeights(splits[local].t.a + splits[local].t.b >> 1)
               : bisectWeightsOf(bisectChild(splits[local].t, at >> 2 + deeper)) * within);
    if (middle) {
        splits[local].middle = moved;
        bisectPutDisplaced(bisectRow(splits[local].slot, 2u));
        bisectPutDisplaced(bisectRow(splits[local].place, 2u));
    }
    return moved;
}

float bisectPointSquare(uint local, uint at, vec3 moved, vec3 within)
{
    return bisectSquare(moved, within, bisectChildPoints(local, at >> 2 + splits[local].deeper));
}

void bisectWorst(uint local, uint at, float sum)
{
    atomicMax(splits[local].worst[at >> 2 + splits[local].deeper], floatBitsToUint(sum / 4.0));
}

// Makes a child of a bisected leaf.
void bisectSplitBegin(uint local, uint child, out Asked a)
{
    uint number = 2u * splits[local].leaf.number + child;
    Leaf leaf = splits[local].leaf;
    a.slot = child == 0u ? splits[local].slot : splits[local].place;
    a.had = leaf;
    a.t = bisectChild(splits[local].t, child);
    a.even = child == 0u;
    a.leaf = Leaf(leaf.base, number,
        min(leaf.own, bisectError(number, uintBitsToFloat(splits[local].worst[child]))),
        child == 0u ? leaf.own : leaf.behind);
}

// Stores the new leaf and adds it to the table.
void bisectSplitEnd(Asked a, Answers answers)
{
    bisectPut(a.slot, a.leaf);
    bisect_work[bisectWord(LIST_FLAGS, a.slot)] = answers.own > 0.0 ? FLAG_WANTED
        : answers.parent <= 0.0 ? FLAG_LESS : 0u;
    bisectInsert(bisectId(a.leaf.base, a.leaf.number), a.slot);
    if (answers.own > 0.0)
        bisect_work[bisectWord(LIST_WANTED + 1u - bisect_state[SWAPPED],
            atomicAdd(bisect_state[WANTED_NEXT], 1u))] = a.slot;
}

#ifndef BISECT_FEW
void bisectSplitChild(uint local, uint child)
{
    Asked a;
    bisectSplitBegin(local, child, a);
    Answers answers = bisectAnswers(a);
    bisectDue(a.slot, answers);
    bisectSplitEnd(a, answers);
}
#endif

#ifdef BISECT_WIDE
// Waits for all threads of a workgroup (barrier).
void bisectTurn()
{
    bisectFence();
    barrier();
}

// Finds the leaf to which a task belongs, by binary search.
uint bisectOf(uint task, uint count)
{
    uint low = 0u, high = count;
    while (high - low > 1u) {
        uint between = (low + high) / 2u;
        if (split_first[between] <= task)
            low = between;
        else
            high = between;
    }
    return low;
}

// Displaces all evaluated points. They are tasks of one list, whichever leaf they belong to:
// midpoints first, then, from a multiple of four on, the points of the children. So the height's
// code occurs only once in the program.
void bisectDisplace(uint count)
{
    uint asked = count + 3u & ~3u, tasks = asked + split_first[count];
    for (uint turn = 0u; turn < tasks; turn += BISECT_THREADS) {
        uint task = turn + gl_LocalInvocationIndex;
        bool middle = task < count, inside = task >= asked && task < tasks;
        uint local = middle ? task : inside ? bisectOf(task - asked, count) : 0u,
            at = inside ? task - asked - split_first[local] : 0u;
        vec3 within = vec3(0.0), moved = vec3(0.0);
        if (middle || inside)
            moved = bisectPoint(local, middle, at, within);
        bisectTurn();
        split_squares[gl_LocalInvocationIndex] = bisectPointSquare(local, at, moved, within);
        bisectTurn();
        if (inside && (at & 3u) == 0u) {
            float sum = 0.0;
            for (uint i = 0u; i < 4u; i++)
                sum += split_squares[gl_LocalInvocationIndex + i];
            bisectWorst(local, at, sum);
        }
    }
}

// Bisects the chosen leaves of the workgroup, except for storing the children; returns the number
// of children.
uint bisectDivide(uint group)
{
    uint first = BISECT_SPLITS * group, all = bisect_state[FULL] != 0u ? 0u : bisect_state[CHOSEN],
        count = min(max(all, first) - first, BISECT_SPLITS);
    if (bisectTask(0u) < count)
        bisectPrepare(bisectTask(0u), bisect_work[bisectWord(LIST_CHOSEN, first + bisectTask(0u))]);
    bisectTurn();
    for (uint i = gl_LocalInvocationIndex; i <= count; i += BISECT_THREADS) {
        split_first[i] = 0u;
        for (uint before = 0u; before < i; before++)
            split_first[i] += 8u << splits[before].deeper;
    }
    for (uint i = gl_LocalInvocationIndex; i < BISECT_ROW * count; i += BISECT_THREADS)
        bisectCopyRows(i / BISECT_ROW, i % BISECT_ROW);
    bisectTurn();
    bisectDisplace(count);
    bisectTurn();
    return 2u * count;
}

#ifndef BISECT_FEW
// Stores both children of each leaf, one thread per child.
void bisectSplit(uint group)
{
    uint children = bisectDivide(group);
    for (uint task = gl_LocalInvocationIndex; task < children; task += BISECT_THREADS)
        bisectSplitChild(task / 2u, task % 2u);
    bisectTurn(); // the next group of leaves reuses the shared memory
}
#endif
#else
// Bisects leaves, one per thread: if threads run sequentially, distributing the points gains
// nothing, and barriers would cost time.
void bisectSplit(uint group)
{
    uint i = bisectTask(group), local = gl_LocalInvocationIndex;
    if (i >= bisect_state[CHOSEN] || bisect_state[FULL] != 0u)
        return;
    bisectPrepare(local, bisect_work[bisectWord(LIST_CHOSEN, i)]);
    for (uint k = 0u; k < BISECT_ROW; k++)
        bisectCopyRows(local, k);
    float sum = 0.0;
    for (uint point = 0u; point <= 8u << splits[local].deeper; point++) {
        vec3 within;
        uint at = point == 0u ? 0u : point - 1u;
        vec3 moved = bisectPoint(local, point == 0u, at, within);
        sum = (at & 3u) == 0u ? 0.0 : sum;
        sum += point == 0u ? 0.0 : bisectPointSquare(local, at, moved, within);
        if (point != 0u && (at & 3u) == 3u)
            bisectWorst(local, at, sum);
    }
    for (uint child = 0u; child < 2u; child++)
        bisectSplitChild(local, child);
}
#endif
#endif
