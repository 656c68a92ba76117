// Intersection of a pixel's ray with a displaced patch: descends the pyramid to triangles of a
// grid, nearest first, and refines the hit to the exact surface by matc_displaced().
//  A triangle is 0.01 wide and its surface 1e-5 above it in its middle: the ray hits the triangle,
//  two steps later a point of the surface with an error below 1e-7.
// polygon offset of depth: the factor and units of glPolygonOffset
uniform vec2 trace_offset;

const int TRACE_STACK = 24; // three entries for each of max six levels, and one more

struct TraceRay {
    vec3 from, along; // t = 0 is the point where the ray leaves the hull
    float begin;      // min ray parameter t
};

struct TraceHit {
    float t;
    vec2 at; // coordinates a and b of the patch
    TracePart part;
};

// Returns the pixel's ray. With perspective t runs from -1, the eye, to 0. Hits in front of the
// near plane are ignored.
TraceRay traceRay()
{
    TraceRay ray;
    ray.from = traceLeaves();
    ray.along = traceWay(ray.from);
    ray.begin = trace_eye.w > 0.0 ? -1.0 : -1e30;
    vec4 from = trace_clipFromLocal * vec4(ray.from, 1.0),
        along = trace_clipFromLocal * vec4(ray.along, 0.0);
    if (along.z < along.w)
        ray.begin = max(ray.begin, (from.z - from.w) / (along.w - along.z));
    return ray;
}

// A triangle near the ray.
struct TraceNear {
    float miss; // distance relative to the triangle's size
    TraceHit hit;
};

// Returns the parameters at which the ray enters and leaves the node; enter > leave: the ray
// misses.
vec2 traceThrough(int number, TracePart part, vec4 from, vec4 inverse)
{
    int node = 2 * traceNode(number, part);
    vec4 a = (trace_nodes[node] - from) * inverse, b = (trace_nodes[node + 1] - from) * inverse;
    vec4 enter = min(a, b), leave = max(a, b);
    return vec2(max(max(enter.x, enter.y), max(enter.z, enter.w)),
        min(min(leave.x, leave.y), min(leave.z, leave.w)));
}

// Records the nearest triangle that the ray misses: the ray's point nearest to the triangle's
// center, and its distance from the triangle relative to the triangle's size.
void tracePass(TracePart part, vec3 p, mat2x3 edges, TraceRay ray, inout TraceNear near)
{
    vec3 n = cross(edges[0], edges[1]), middle = p + (edges[0] + edges[1]) / 3.0;
    float area = dot(n, n), t = dot(middle - ray.from, ray.along) / dot(ray.along, ray.along);
    if (area == 0.0 || t < ray.begin || t > 0.0)
        return;
    vec3 to = ray.from + t * ray.along - p;
    vec2 at = vec2(dot(cross(to, edges[1]), n), dot(cross(edges[0], to), n)) / area;
    float miss = max(max(-min(at.x, at.y), at.x + at.y - 1.0), 0.0) +
        abs(dot(to, n)) / area * sqrt(sqrt(area));
    if (miss > near.miss)
        return;
    ivec2 corners[3];
    traceCorners(part, corners);
    at = max(at, vec2(0.0));
    at /= max(at.x + at.y, 1.0);
    vec2 first = vec2(corners[0]), place = first + at.x * (vec2(corners[1]) - first) +
        at.y * (vec2(corners[2]) - first);
    near = TraceNear(miss, TraceHit(t, clamp(place / float(trace_parts), vec2(0.0), vec2(1.0)),
        part));
}

// Intersects a triangle of the grid; neighbors overlap slightly, so that no ray passes between
// them.
void traceTriangle(int number, TracePart part, TraceRay ray, inout TraceHit hit,
    inout TraceNear near)
{
    const float OVERLAP = 1e-4;
    ivec2 corners[3];
    traceCorners(part, corners);
    vec3 p = traceVector(traceRow(number, corners[0]), TRACE_POSITION);
    vec3 u = traceVector(traceRow(number, corners[1]), TRACE_POSITION) - p;
    vec3 v = traceVector(traceRow(number, corners[2]), TRACE_POSITION) - p;
    vec3 n = cross(u, v), to = p - ray.from;
    float across = dot(n, ray.along);
    tracePass(part, p, mat2x3(u, v), ray, near);
    if (across == 0.0)
        return;
    float t = dot(n, to) / across;
    vec3 turned = cross(to, ray.along) / across;
    float x = dot(v, turned), y = -dot(u, turned);
    if (min(min(x, y), 1.0 - x - y) < -OVERLAP || t < ray.begin || t > hit.t)
        return;
    vec2 first = vec2(corners[0]), at = first + x * (vec2(corners[1]) - first) +
        y * (vec2(corners[2]) - first);
    hit = TraceHit(t, clamp(at / float(trace_parts), vec2(0.0), vec2(1.0)), part);
}

int traceCode(TracePart part)
{
    return part.level << 24 | int(part.between) << 20 | part.at.x << 10 | part.at.y;
}
TracePart tracePart(int code)
{
    return TracePart(code >> 24, ivec2(code >> 10, code) & 1023, (code >> 20 & 1) == 1);
}

// Returns the nearest intersection with the grid; hit.t is 1 for a miss.
TraceHit traceGrid(int number, TraceSpace space, TraceRay ray, out TraceNear near)
{
    near = TraceNear(0.25, TraceHit(1.0, vec2(0.0), TracePart(0, ivec2(0), false)));
    TraceHit hit = TraceHit(1.0, vec2(0.0), TracePart(0, ivec2(0), false));
    vec3 p = space.inner * (ray.from - space.corner), d = space.inner * ray.along;
    vec4 from = vec4(p.xy, p.x - p.y, p.z), along = vec4(d.xy, d.x - d.y, d.z);
    vec4 inverse = 1.0 / mix(along, vec4(1e-25), lessThan(abs(along), vec4(1e-25)));
    int stack[TRACE_STACK], count = 1;
    float enters[TRACE_STACK];
    stack[0] = 0;
    enters[0] = -1e30;
    while (count > 0) {
        count--;
        TracePart part = tracePart(stack[count]);
        if (enters[count] > hit.t)
            continue;
        bool last = 2 << part.level == trace_parts;
        int first = count;
        for (int k = 0; k < 4; k++) {
            TracePart child = traceChild(part, k);
            if (last) {
                traceTriangle(number, child, ray, hit, near);
                continue;
            }
            vec2 through = traceThrough(number, child, from, inverse);
            if (through.x > through.y || through.y < ray.begin || through.x > min(hit.t, 0.0))
                continue;
            int at = count++; // keeps the nearest node on top of the stack
            for (; at > first && enters[at - 1] < through.x; at--) {
                stack[at] = stack[at - 1];
                enters[at] = enters[at - 1];
            }
            stack[at] = traceCode(child);
            enters[at] = through.x;
        }
    }
    return hit;
}

// Sets the derivatives of the surface by a and b, from its triangle at that part.
void traceSlopes(int number, TracePart part, out vec3 byA, out vec3 byB)
{
    ivec2 corners[3];
    vec3 p[3];
    traceCorners(part, corners);
    for (int i = 0; i < 3; i++)
        p[i] = traceVector(traceRow(number, corners[i]), TRACE_POSITION);
    byA = float(trace_parts) * (part.between ? p[1] - p[2] : p[1] - p[0]);
    byB = float(trace_parts) * (part.between ? p[2] - p[0] : p[2] - p[1]);
}

// Refines a hit from the triangle to the surface, within the adjacent triangles: Broyden's method
// on the distance between the surface at (a, b) and the ray at t, starting with the triangle's
// slopes, which each step corrects. Without convergence, as where the height jumps, the hit stays
// on the triangle. Returns the remaining distance.
float traceSurface(int number, TraceRay ray, inout TraceHit hit)
{
    const int STEPS = 8;
    const float NEAR = 1e-7; // tolerance relative to the ray's length
    vec3 byA, byB, move = vec3(0.0), before = vec3(0.0);
    traceSlopes(number, hit.part, byA, byB);
    float volume = dot(cross(byA, byB), ray.along), least = 1e30, enough = NEAR * length(ray.along);
    // rows of the inverse Jacobian
    mat3 rows = mat3(cross(byB, ray.along), cross(ray.along, byA), -cross(byA, byB)) *
        (volume == 0.0 ? 0.0 : 1.0 / volume);
    vec3 x = vec3(hit.at, hit.t), first = x;
    for (int step = 0; step < STEPS; step++) {
        displaceAt(uint(number), vec3(1.0 - x.x, x.x - x.y, x.y), false);
        vec3 off = displaced_position - (ray.from + ray.along * x.z);
        float size = dot(off, off);
        if (size < least) {
            least = size;
            hit.at = x.xy;
            hit.t = x.z;
        }
        vec3 found = (off - before) * rows; // dot products of the offset with each row
        float scale = dot(move, found);
        if (step > 0 && abs(scale) > 1e-30) {
            vec3 along = rows * move / scale, more = move - found;
            rows += mat3(more.x * along, more.y * along, more.z * along);
        }
        vec3 to = x - off * rows;
        to.xy = clamp(to.xy, first.xy - 1.0 / float(trace_parts),
            first.xy + 1.0 / float(trace_parts));
        to.x = clamp(to.x, 0.0, 1.0);
        to.y = clamp(to.y, 0.0, to.x);
        move = to - x;
        x = to;
        before = off;
        if (size < enough * enough || move == vec3(0.0))
            break;
    }
    return sqrt(least);
}

// Returns true if the surface is hit next to a triangle that the ray misses: outside the grid's
// silhouette, where the surface bulges.
bool traceBeside(int number, TraceRay ray, TraceHit hit, float off)
{
    vec3 byA, byB;
    traceSlopes(number, hit.part, byA, byB);
    return off < 1e-3 * (length(byA) + length(byB)) / float(trace_parts) && hit.t >= ray.begin &&
        hit.t <= 0.0;
}

// Returns the polygon offset, which has no effect if the program writes depth.
float traceOffset(int number, TracePart part, vec4 clip)
{
    vec3 byA, byB;
    traceSlopes(number, part, byA, byB);
    vec4 a = trace_clipFromLocal * vec4(byA, 0.0), b = trace_clipFromLocal * vec4(byB, 0.0);
    vec3 ndc = clip.xyz / clip.w, rowA = (a.xyz - ndc * a.w) / clip.w,
        rowB = (b.xyz - ndc * b.w) / clip.w;
    float turn = rowA.x * rowB.y - rowA.y * rowB.x;
    vec2 slope = vec2(rowA.z * rowB.y - rowB.z * rowA.y, rowB.z * rowA.x - rowA.z * rowB.x) /
        (turn == 0.0 ? 1e-30 : turn);
    float least = exp2(floor(log2(max(ndc.z, 1e-30))) - 23.0);
    return trace_offset.x * max(abs(slope.x * trace_pixel.x), abs(slope.y * trace_pixel.y)) +
        trace_offset.y * least;
}

void main()
{
    int number = gl_PrimitiveID / 8; // a hull has 8 triangles
    TraceRay ray = traceRay();
    TraceNear near;
    TraceHit hit = traceGrid(number, traceSpace(number), ray, near);
    bool beside = hit.t > 0.0;
    if (beside && near.hit.t > 0.0)
        discard;
    if (beside)
        hit = near.hit;
    float off = traceSurface(number, ray, hit);
    if (beside && !traceBeside(number, ray, hit, off))
        discard;
    vec4 clip = traceMeet(number, hit.at, ray.from + ray.along * hit.t);
    if (trace_offset != vec2(0.0))
        gl_FragDepth += traceOffset(number, hit.part, clip);
}
