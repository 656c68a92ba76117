// Pyramid of bounds for ray marching: a node has the minimum and the maximum of a, b, a - b and z
// over all its triangles (trace_patch.glsl), enlarged by the surface's distance from the triangles.
// The finest level is computed from four triangles per node, the others from four child nodes.
layout(local_size_x = 64) in;
layout(std430, binding = 5) buffer TraceNodes {
    vec4 trace_nodes[];
};
uniform int trace_level, trace_patches;

void traceInclude(TraceSpace space, int row, inout vec4 low, inout vec4 high)
{
    vec3 p = space.inner * (traceVector(row, TRACE_POSITION) - space.corner);
    vec4 slabs = vec4(p.xy, p.x - p.y, p.z);
    low = min(low, slabs);
    high = max(high, slabs);
}

// Returns bounds of the surface's distance from the four triangles: half the deviation of the
// midpoints of the three edges around them. For a parabola it would be a quarter.
vec4 traceBulge(int number, TraceSpace space, TracePart part)
{
    ivec2 corners[3];
    vec3 p[3], most = vec3(0.0);
    float aside = 0.0;
    traceCorners(part, corners);
    for (int i = 0; i < 3; i++)
        p[i] = traceVector(traceRow(number, 2 * corners[i]), TRACE_POSITION);
    for (int i = 0; i < 3; i++) {
        int k = (i + 1) % 3;
        vec3 off = space.inner * (traceVector(traceRow(number, corners[i] + corners[k]),
            TRACE_POSITION) - 0.5 * (p[i] + p[k]));
        most = max(most, abs(off));
        aside = max(aside, abs(off.x - off.y));
    }
    return 0.5 * vec4(most.xy, aside, most.z);
}

void main()
{
    int each = 1 << 2 * trace_level, at = int(gl_GlobalInvocationID.x);
    if (at >= trace_patches * each)
        return;
    int number = at / each, place = at % each;
    int row = int(sqrt(float(place)));
    row += int((row + 1) * (row + 1) <= place) - int(row * row > place);
    int along = place - row * row;
    TracePart part = TracePart(trace_level, ivec2(row, along / 2), along % 2 == 1);
    vec4 low = vec4(1e30), high = vec4(-1e30);
    if (2 << trace_level == trace_parts) {
        TraceSpace space = traceSpace(number);
        ivec2 corners[3];
        for (int k = 0; k < 3; k++) { // the triangle in the middle has no other corners
            traceCorners(traceChild(part, k), corners);
            for (int i = 0; i < 3; i++)
                traceInclude(space, traceRow(number, corners[i]), low, high);
        }
        vec4 bulge = traceBulge(number, space, part);
        low -= bulge;
        high += bulge;
    } else
        for (int k = 0; k < 4; k++) {
            int node = 2 * traceNode(number, traceChild(part, k));
            low = min(low, trace_nodes[node]);
            high = max(high, trace_nodes[node + 1]);
        }
    int node = 2 * traceNode(number, part);
    trace_nodes[node] = low;
    trace_nodes[node + 1] = high;
}
