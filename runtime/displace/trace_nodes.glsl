// The pyramid of what is traced: a node has the least and the greatest a, b, a - b and z of all triangles in it (trace_patch.glsl). The finest level asks its four triangles, the others four nodes each.
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
        for (int k = 0; k < 3; k++) { // the one in the middle has no other corners
            traceCorners(traceChild(part, k), corners);
            for (int i = 0; i < 3; i++)
                traceInclude(space, traceRow(number, corners[i]), low, high);
        }
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
