// Parallax occlusion mapping: a ray advances in equal steps along the tangent plane of the triangle
// that it hits, from the surface's maximum height to its minimum, and then by secants to the point
// where it first comes below the surface. Steps are 1 / trace_parts of a patch edge long, but at
// least 4, and at most 32 for slanted rays. Outside the triangle its map continues. Only z is
// displaced (trace_patch.glsl): the silhouette is the triangle's, and overhangs are straightened.
//  At 60 degrees from the normal, a height of 0.1 either way: the ray runs over 0.35 of the plane,
//  of a patch with an edge of 1 in 32 parts in 12 steps.

// Returns the signed height of the ray's point above the surface; the ray crosses the surface where
// the sign changes.
float parallaxOver(int number, TraceSpace space, vec3 at)
{
    displaceAt(uint(number), vec3(1.0 - at.x, at.x - at.y, at.y), false);
    return at.z - (space.inner * (displaced_position - space.corner)).z;
}

void main()
{
    // min and max steps; steps of regula falsi, which halves the height at an end that stays
    // (Illinois method)
    const int LEAST = 4, MOST = 32, SECANTS = 6;
    // minimum cosine to the normal; tolerance relative to the range of heights
    const float SLANTED = 1e-3, NEAR = 1e-7;
    int number = gl_PrimitiveID;
    TraceSpace space = traceSpace(number);
    int node = 2 * traceNode(number, TracePart(0, ivec2(0), false));
    vec3 leaves = traceLeaves(), way = traceWay(leaves);
    vec3 from = space.inner * (leaves - space.corner), along = space.inner * way;
    float side = along.z < 0.0 ? 1.0 : -1.0; // 1: the ray enters from above; -1: from below
    vec2 heights = vec2(trace_nodes[node].w, trace_nodes[node + 1].w) /
        max(abs(along.z), SLANTED * length(way));
    vec2 ends = side > 0.0 ? -heights.yx : heights; // begin and end of the march along the ray
    if (trace_eye.w > 0.0)
        ends = max(ends, -0.99); // the march must not begin behind the eye
    int steps = int(clamp(ceil(length(along.xy) * (ends.y - ends.x) * float(trace_parts)),
        float(LEAST), float(MOST)));
    float enough = NEAR * (trace_nodes[node + 1].w - trace_nodes[node].w);
    // heights over the surface and ray parameters, on both sides of the hit
    vec2 over = vec2(1.0, -1.0), between = ends;
    float t = ends.x, last = 0.0;
    bool found = false;
    for (int step = 0, left = SECANTS; step <= steps && left > 0; step += int(!found),
        left -= int(found)) {
        t = found ? between.x + (between.y - between.x) * over.x / (over.x - over.y)
            : mix(ends.x, ends.y, float(step) / float(steps));
        float here = side * parallaxOver(number, space, from + along * t);
        if (step == 0 && here <= 0.0)
            break;
        if (here > 0.0) {
            between.x = t;
            over = vec2(here, found && last > 0.0 ? 0.5 * over.y : over.y);
        } else {
            between.y = t;
            over = vec2(found && last < 0.0 ? 0.5 * over.x : over.x, here - 1e-20);
            found = true;
        }
        last = here;
        if (abs(here) <= enough)
            break;
    }
    traceMeet(number, (from + along * t).xy, leaves + way * t);
}
