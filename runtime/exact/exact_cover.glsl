// Lists of exact shadows: finds the cells of a light's view that a triangle covers, first to count
// them, then to list them.
//
// Seen from the light, a triangle and a cell are cones with three and four sides. They are disjoint
// if and only if the plane of a side of one has all of the other outside. So no clipping is needed,
// and corners may be behind the light. In a row of cells each side of the triangle bounds the
// covered cells from below or above.
//
//  a triangle (0.5, 0.5), (2.5, 0.5), (0.5, 1.5) in cells, with a side x + 2 y <= 3.5: in row 0,
//  whose lowest y is 0, the side gives x <= 3.5, and the corners x <= 2.5: cells 0, 1, 2; in row 1
//  x <= 1.5: cells 0 and 1. Five entries
//
// All arithmetic is in double, from corners and headers in floats. A corner's position has an error
// of 1e-9 cells. A side is the cross product of two corners, whose error is bounded by 2^-44 times
// the product of their greatest components, as double operations round by 2^-53. The decisive error
// is that of exact.glsl, which finds a point's cell in floats, with an error of 1e-4 cells: a
// position is a sum of three products, or a quotient of two such sums, times half the number of
// cells of a view's edge, at most 512. So cells are enlarged by 1/64 on all sides.
//
// There is a thread for each triangle, then a workgroup for each block of rows of the triangles
// that cover many cells: no thread visits more than 256 cells. Counting and listing are one
// program, so that both find the same cells.
layout(local_size_x = 64) in;

#include "exact_lists.layout.def"
const int ROWS = 16; // rows of a block
const int FEW = 64; // max cells that one thread handles
const uint MANY_BLOCKS = (1u << 21) - 4u; // further blocks are not counted
const double SPREAD = 1.0lf / 64.0lf; // enlargement of a cell on each side, in cells
const double ROUNDING = 1.0lf / 17592186044416.0lf; // relative rounding error, 2^-44
const double FAR = 1e300lf;

layout(std430, binding = 5) coherent buffer ExactWork {
#include "exact_work.layout.def"
    uvec2 exact_queue[]; // queued blocks: the triangle and face; the light and the block's number
};
layout(std430, binding = 6) readonly buffer ExactTriangles {
    vec4 exact_corners[];
};
layout(std430, binding = 7) buffer ExactLists {
    uint exact_words[];
};
uniform bool exact_lists; // true: writes the lists; false: counts only
uniform bool exact_rows; // true: a thread handles a block of rows; false: a triangle

struct View {
    bool placed;
    dvec3 from;
    dvec4 rows[3];
    int faces, size;
    uint cells;
};

View viewOf(uint light)
{
    uint head = light * EXACT_HEAD;
    View view;
    vec4 row[4];
    for (int i = 0; i < 16; i++)
        row[i / 4][i % 4] = uintBitsToFloat(exact_words[head + uint(i)]);
    view.placed = row[0].w > 0.0;
    view.from = dvec3(row[0].xyz);
    for (int i = 0; i < 3; i++)
        view.rows[i] = dvec4(row[i + 1]);
    view.faces = int(exact_words[head + EXACT_VIEWS]);
    view.size = int(exact_words[head + EXACT_SIZE]);
    view.cells = exact_words[head + EXACT_CELLS];
    return view;
}

// -- triangles, as seen from the light

// A triangle in a view: corners, x and y in cells times z; side planes, each opposite to its
// corner, with product 0 for corners on it, and the product's error bound; `turn`: sign of the
// inside, 0 if unknown, as the light is in the triangle's plane.
struct Microfacet {
    dvec3 corners[3], sides[3];
    double off[3];
    int turn;
    ivec4 bounds; // first and last row, first and last column; empty: last < first
};

// Returns a corner in the light's coordinates.
dvec3 placeOf(View view, uint triangle, uint corner)
{
    dvec3 from = dvec3(exact_corners[triangle * 3u + corner].xyz) -
        (view.placed ? view.from : dvec3(0.0lf));
    return dvec3(dot(view.rows[0].xyz, from) + view.rows[0].w, dot(view.rows[1].xyz, from) +
        view.rows[1].w,
                 view.placed ? dot(view.rows[2].xyz, from) + view.rows[2].w : 1.0lf);
}

dvec3[3] placesOf(View view, uint triangle)
{
    return dvec3[3](placeOf(view, triangle, 0u), placeOf(view, triangle, 1u),
        placeOf(view, triangle, 2u));
}

// Permutes to the axes of a face: face 2 k faces along axis k, 2 k + 1 against it.
dvec3 turned(dvec3 place, View view, int face)
{
    if (view.faces > 1) {
        place = face / 2 == 0 ? place.yzx : face / 2 == 1 ? place.zxy : place;
        place.z = face % 2 == 0 ? place.z : -place.z;
    }
    return dvec3((place.xy + place.z) * (0.5lf * double(view.size)), place.z);
}

// Returns true if all three signed distances from a plane are negative: the corners are outside.
bool areBeyond(double a, double b, double c) { return max(max(a, b), c) < 0.0lf; }

bool isAway(dvec3 a, dvec3 b, dvec3 c, double size)
{
    double from = -SPREAD, to = size + SPREAD;
    return areBeyond(a.z, b.z, c.z) ||
        areBeyond(a.x - from * a.z, b.x - from * b.z, c.x - from * c.z) ||
           areBeyond(to * a.z - a.x, to * b.z - b.x, to * c.z - c.x) ||
               areBeyond(a.y - from * a.z, b.y - from * b.z, c.y - from * c.z) ||
           areBeyond(to * a.z - a.y, to * b.z - b.y, to * c.z - c.y);
}

int cellOf(double at, int size) { return int(clamp(floor(at), 0.0lf, double(size - 1))); }

// Returns the rows and columns that the corners span; the whole face if a corner is not in front of
// the light.
ivec4 boundsOf(dvec3 a, dvec3 b, dvec3 c, int size)
{
    if (min(min(a.z, b.z), c.z) <= 0.0lf) return ivec4(0, size - 1, 0, size - 1);
    dvec2 u = a.xy / a.z, v = b.xy / b.z, w = c.xy / c.z;
    dvec2 low = min(min(u, v), w) - SPREAD, high = max(max(u, v), w) + SPREAD;
    return ivec4(cellOf(low.y, size), cellOf(high.y, size), cellOf(low.x, size),
        cellOf(high.x, size));
}

double greatest(dvec3 corner, double size)
{
    return max(max(abs(corner.x), abs(corner.y)), abs(corner.z) * size);
}

Microfacet microfacetOf(View view, dvec3 places[3], int face)
{
    Microfacet microfacet;
    double size = double(view.size), most[3];
    for (int i = 0; i < 3; i++) {
        microfacet.corners[i] = turned(places[i], view, face);
        most[i] = greatest(microfacet.corners[i], size);
    }
    dvec3 a = microfacet.corners[0], b = microfacet.corners[1], c = microfacet.corners[2];
    microfacet.bounds = ivec4(0, -1, 0, -1);
    if (isAway(a, b, c, size)) return microfacet;
    microfacet.bounds = boundsOf(a, b, c, view.size);
    microfacet.sides = dvec3[3](cross(b, c), cross(c, a), cross(a, b));
    microfacet.off = double[3](ROUNDING * most[1] * most[2], ROUNDING * most[2] * most[0],
        ROUNDING * most[0] * most[1]);
    double volume = dot(a, microfacet.sides[0]), least = microfacet.off[0] * most[0] / size;
    microfacet.turn = volume > least ? 1 : volume < -least ? -1 : 0;
    return microfacet;
}

// -- cells of a row

// Clips a range of x by a side, in a row from y = heights.x to heights.y; a turn of -1 has its
// inside on the other side.
void cutRange(dvec3 side, double off, double turn, dvec2 heights, inout dvec2 range)
{
    dvec3 inward = turn * side;
    double rest = inward.y * (inward.y > 0.0lf ? heights.y : heights.x) + inward.z + off,
        x = -rest / inward.x;
    if (inward.x > 0.0lf) range.x = max(range.x, x);
    else if (inward.x < 0.0lf) range.y = min(range.y, x);
    else if (rest < 0.0lf) range = dvec2(FAR, -FAR);
}

// Returns the cells, enlarged by 1/64, that intersect the range left by the three sides.
ivec2 cellsLeft(Microfacet microfacet, double turn, dvec2 heights, int size)
{
    dvec2 range = dvec2(-FAR, FAR);
    for (int i = 0; i < 3; i++)
        cutRange(microfacet.sides[i], microfacet.off[i], turn, heights, range);
    range = clamp(range + dvec2(-SPREAD, SPREAD), -1.0lf, double(size));
    return ivec2(int(floor(range.x)), int(floor(range.y)));
}

// Returns the first and last cell of a row. If the inside is unknown, both signs are tried.
ivec2 cellsOf(Microfacet microfacet, int row, int size)
{
    dvec2 heights = dvec2(double(row) - SPREAD, double(row + 1) + SPREAD);
    dvec3 a = microfacet.corners[0], b = microfacet.corners[1], c = microfacet.corners[2];
    if (areBeyond(a.y - heights.x * a.z, b.y - heights.x * b.z, c.y - heights.x * c.z) ||
        areBeyond(heights.y * a.z - a.y, heights.y * b.z - b.y,
            heights.y * c.z - c.y)) return ivec2(0, -1);
    ivec2 cells = cellsLeft(microfacet, microfacet.turn < 0 ? -1.0lf : 1.0lf, heights, size);
    ivec2 other = microfacet.turn == 0 ? cellsLeft(microfacet, -1.0lf, heights, size) : cells;
    if (cells.x > cells.y || (other.x <= other.y && other.x < cells.x)) cells.x = other.x;
    cells.y = max(cells.y, other.y);
    return ivec2(max(cells.x, microfacet.bounds.z), min(cells.y, microfacet.bounds.w));
}

// -- lists

// Counts or stores an entry. Each cell has two words: begin and end of its list; while entries are
// counted, the second is their number.
void addCell(uint cell, uint triangle)
{
    uint at = atomicAdd(exact_words[cell + 1u], 1u);
    if (exact_lists) exact_words[at] = triangle;
}

// Adds every `steps.y`th covered cell of a row, from number `steps.x` on. Returns their number.
uint addRow(View view, Microfacet microfacet, uvec2 number, int row, ivec2 steps)
{
    ivec2 cells = cellsOf(microfacet, row, view.size);
    uint line = view.cells + 2u * uint((int(number.y) * view.size + row) * view.size), count = 0u;
    for (int cell = cells.x + steps.x; cell <= cells.y; cell += steps.y, count++)
        addCell(line + 2u * uint(cell), number.x);
    return count;
}

bool isTooMuch() { return exact_entries > exact_most || exact_blocks > MANY_BLOCKS; }

void queueBlocks(uvec2 number, uint light, ivec4 bounds)
{
    uint count = uint((bounds.y - bounds.x) / ROWS + 1), at = atomicAdd(exact_blocks, count);
    for (uint i = 0u; i < count && at + i < exact_capacity; i++)
        exact_queue[at + i] = uvec2(number.x * 8u + number.y, light << 16 | i);
}

// Adds a triangle in one face's view. Returns the number of entries.
uint addMicrofacet(View view, Microfacet microfacet, uvec2 number, uint light)
{
    ivec4 bounds = microfacet.bounds;
    uint count = 0u;
    if ((bounds.y - bounds.x + 1) * (bounds.w - bounds.z + 1) > FEW) {
        if (!exact_lists) queueBlocks(number, light, bounds);
        return 0u;
    }
    for (int row = bounds.x; row <= bounds.y; row++)
        count += addRow(view, microfacet, number, row, ivec2(0, 1));
    return count;
}

uint addTriangle(View view, uint triangle, uint light)
{
    dvec3 places[3] = placesOf(view, triangle);
    uint count = 0u;
    for (int face = 0; face < view.faces; face++)
        count += addMicrofacet(view, microfacetOf(view, places, face), uvec2(triangle, face),
            light);
    return count;
}

shared uint group_entries;

void addTriangles(uint light)
{
    View view = viewOf(light);
    uint count = 0u;
    if (gl_LocalInvocationIndex == 0u) group_entries = 0u;
    barrier();
    for (uint t = gl_GlobalInvocationID.x; t < exact_triangles; t += gl_NumWorkGroups.x * 64u)
        if (exact_lists || !isTooMuch()) count += addTriangle(view, t, light);
    atomicAdd(group_entries, count);
    barrier();
    if (gl_LocalInvocationIndex == 0u && !exact_lists && group_entries > 0u)
        atomicAdd(exact_entries, group_entries);
}

void addBlock(uvec2 block)
{
    View view = viewOf(block.y >> 16);
    uvec2 number = uvec2(block.x / 8u, block.x % 8u);
    Microfacet microfacet = microfacetOf(view, placesOf(view, number.x), int(number.y));
    int thread = int(gl_LocalInvocationIndex), row = microfacet.bounds.x +
        int(block.y & 65535u) * ROWS + thread % ROWS;
    if (row > microfacet.bounds.y) return;
    uint count = addRow(view, microfacet, number, row, ivec2(thread / ROWS, 64 / ROWS));
    if (!exact_lists && count > 0u) atomicAdd(exact_entries, count);
}

void main()
{
    if (!exact_rows) addTriangles(gl_WorkGroupID.y);
    else
        for (uint i = gl_WorkGroupID.x; i < min(exact_blocks, exact_capacity);
            i += gl_NumWorkGroups.x)
            if (exact_lists || !isTooMuch()) addBlock(exact_queue[i]);
}
