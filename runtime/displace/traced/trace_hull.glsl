// Hull around a ray-marched patch: a prism of six points, whose sides are the bounds of the root
// node. Rays that hit the patch pass through the hull. For parallax, the base triangle.
layout(local_size_x = 64) in;
layout(std430, binding = 5) readonly buffer TraceNodes {
    vec4 trace_nodes[];
};
layout(std430, binding = 3) writeonly buffer TraceHulls {
    float trace_hulls[];
};
uniform int trace_patches, trace_hull; // `trace_hull` is the number of triangles of a hull

void tracePut(int point, vec3 p)
{
    for (int component = 0; component < 3; component++)
        trace_hulls[TRACE_ROW * point + component] = p[component];
}

void main()
{
    int number = int(gl_GlobalInvocationID.x);
    if (number >= trace_patches)
        return;
    TraceSpace space = traceSpace(number);
    if (trace_hull == 1) {
        for (int i = 0; i < 3; i++)
            tracePut(3 * number + i, space.corner +
                space.local * vec3(min(i, 1), max(i - 1, 0), 0.0));
        return;
    }
    int node = 2 * traceNode(number, TracePart(0, ivec2(0), false));
    vec4 low = trace_nodes[node], high = trace_nodes[node + 1];
    // margin that gives the hull a volume, and covers rounding
    vec4 more = 1e-3 * (high - low) + vec4(vec3(1e-4), 1e-4 * length(space.local[0]));
    low -= more;
    high += more;
    vec2 corners[3] = vec2[3](vec2(low.y + low.z, low.y), vec2(high.x, low.y),
        vec2(high.x, high.x - low.z));
    for (int i = 0; i < 6; i++)
        tracePut(6 * number + i, space.corner +
            space.local * vec3(corners[i % 3], i < 3 ? low.w : high.w));
}
