// Parallax occlusion: a ray goes in even steps along the tangent plane of the triangle that it
// meets, from where the surface is highest to where it is lowest, and by secants to where it first
// comes below the surface. A step is a part of an edge of the patch long, as far as there are
// steps: straight on there are four, aslant 32. Beyond the triangle its map goes on as within. Only
// z counts (trace_patch.glsl): there is no outline but the triangle's, and what leans is as if it
// stood.
//     At 60 degrees from the normal, a height of 0.1 either way: the ray runs over 0.35 of the
//         plane, of a patch with an edge of 1 in 32 parts in 12 steps.
// How far the ray is above the surface at t: where that has another sign, it is on the other side.
float parallaxOver(int number, TraceSpace space, vec3 at)
{
    displaceAt(uint(number), vec3(1.0 - at.x, at.x - at.y, at.y), false);
    return at.z - (space.inner * (displaced_position - space.corner)).z;
}

void main()
{
    const int LEAST = 4, MOST = 32, SECANTS = 6; // by regula falsi: of an end that stays, half the height counts (Illinois)
    const float SLANTED = 1e-3, NEAR = 1e-7;     // of a ray's length: what is along the normal is at least so much; of heights
    int number = gl_PrimitiveID;
    TraceSpace space = traceSpace(number);
    int node = 2 * traceNode(number, TracePart(0, ivec2(0), false));
    vec3 leaves = traceLeaves(), way = traceWay(leaves);
    vec3 from = space.inner * (leaves - space.corner), along = space.inner * way;
    float side = along.z < 0.0 ? 1.0 : -1.0; // from above, or from below
    vec2 heights = vec2(trace_nodes[node].w, trace_nodes[node + 1].w) / max(abs(along.z), SLANTED * length(way));
    vec2 ends = side > 0.0 ? -heights.yx : heights; // where it begins, and where it ends
    if (trace_eye.w > 0.0)
        ends = max(ends, -0.99); // nothing is behind the eye
    int steps = int(clamp(ceil(length(along.xy) * (ends.y - ends.x) * float(trace_parts)), float(LEAST), float(MOST)));
    float enough = NEAR * (trace_nodes[node + 1].w - trace_nodes[node].w);
    vec2 over = vec2(1.0, -1.0), between = ends; // on both sides of the surface: heights, and where
    float t = ends.x, last = 0.0;
    bool found = false;
    for (int step = 0, left = SECANTS; step <= steps && left > 0; step += int(!found), left -= int(found)) {
        t = found ? between.x + (between.y - between.x) * over.x / (over.x - over.y) : mix(ends.x, ends.y, float(step) / float(steps));
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
