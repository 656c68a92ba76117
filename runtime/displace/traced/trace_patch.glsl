// A ray-marched patch: its grid of triangles (displaced_grid.c), and the space in which rays are
// traced. In that space a point is (a, b, z): corner 0 + a (corner 1 - corner 0) + b (corner 2 -
// corner 1) + z n, with n the unit normal of the base triangle, and 0 <= b <= a <= 1 inside it.
//  Row i of a grid of 4 parts, point j in it: the base is at a = i / 4, b = j / 4.
layout(std430, binding = 4) readonly buffer TraceRows {
    float trace_rows[]; // vertices of the grid, as in MeshCaptured
};
uniform int trace_parts; // number of parts of an edge: a power of two

const int TRACE_ROW = 17, TRACE_POSITION = 0, TRACE_NORMAL = 3, TRACE_TEXCOORD = 6,
    TRACE_TANGENT_U = 8, TRACE_TANGENT_V = 11, TRACE_BASE = 14;

int traceRow(int number, ivec2 at)
{
    return TRACE_ROW * (number * ((trace_parts + 1) * (trace_parts + 2) / 2) +
        at.x * (at.x + 1) / 2 + at.y);
}

vec3 traceVector(int row, int part)
{
    return vec3(trace_rows[row + part], trace_rows[row + part + 1], trace_rows[row + part + 2]);
}

struct TraceSpace {
    vec3 corner; // position of corner 0
    mat3 local;  // matrix from the patch's space to object space
    mat3 inner;  // matrix from object space; 0 for a degenerate base triangle
};

TraceSpace traceSpace(int number)
{
    TraceSpace space;
    space.corner = traceVector(traceRow(number, ivec2(0)), TRACE_BASE);
    vec3 first = traceVector(traceRow(number, ivec2(trace_parts, 0)), TRACE_BASE);
    vec3 a = first - space.corner,
        b = traceVector(traceRow(number, ivec2(trace_parts)), TRACE_BASE) - first;
    vec3 across = cross(a, b);
    float area = length(across);
    vec3 n = area > 0.0 ? across / area : vec3(0.0);
    float scale = area > 0.0 ? 1.0 / area : 0.0; // reciprocal of the determinant
    space.local = mat3(a, b, n);
    space.inner = transpose(mat3(cross(b, n) * scale, cross(n, a) * scale, n));
    return space;
}

// A triangle of a level: row i, position j in it; `between`: it is between two others of its row,
// with its tip at the top.
//  corners of a triangle (i, j), (i + 1, j), (i + 1, j + 1), of one between (i, j),
//  (i + 1, j + 1), (i, j + 1)
struct TracePart {
    int level;
    ivec2 at;
    bool between;
};

// Returns child 0 to 3 of a triangle, on the next finer level.
TracePart traceChild(TracePart of, int k)
{
    TracePart child = TracePart(of.level + 1, 2 * of.at, of.between);
    if (of.between)
        child.at += k == 0 ? ivec2(0) : k == 1 ? ivec2(0, 1) : ivec2(1, 1);
    else
        child.at += k == 0 ? ivec2(0) : k == 2 ? ivec2(1, 1) : ivec2(1, 0);
    if (of.between && k == 3)
        child.at = 2 * of.at + ivec2(0, 1);
    child.between = of.between != (k == 3);
    return child;
}

void traceCorners(TracePart part, out ivec2 corners[3])
{
    corners[0] = part.at;
    corners[1] = part.at + (part.between ? ivec2(1, 1) : ivec2(1, 0));
    corners[2] = part.at + (part.between ? ivec2(0, 1) : ivec2(1, 1));
}

// Returns the index of a node in its patch's pyramid: levels before the last, each with 4^level
// nodes in rows.
int traceNode(int number, TracePart part)
{
    int before = ((1 << 2 * part.level) - 1) / 3, all = (trace_parts * trace_parts - 1) / 3;
    return number * all + before + part.at.x * part.at.x + 2 * part.at.y + int(part.between);
}
