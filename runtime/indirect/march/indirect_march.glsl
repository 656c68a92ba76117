// Ray marching through the depth buffer (Thiedemann 2009, 4.3): INDIRECT_STEPS even steps; the
// first sample behind the surface of its pixel is the hit. A ray that leaves the picture ends
// without a hit.
//
// IndirectStep: a sample of the ray, with its position in the picture.
struct IndirectStep {
    vec3 point;
    vec2 place;
    float t;
};

#ifdef INDIRECT_PICTURE
// Steps that are even in the picture. For a segment projected to a and b, the point at mix(a, b, s)
// lies at a share t of the segment, by perspective-correct interpolation with the distances of the
// ends.
struct IndirectLine {
    vec2 a, b;
    // end: share of the ray that lies before the eye; over0, over1: 1 / distance of the ends
    float end, over0, over1;
};

IndirectLine indirectLine(vec3 from, vec3 way)
{
    float least = indirectIsOrthographic() ? -1e30 : 0.999 * indirect_view.x, end = 1.0;
    if (from.z + way.z > -least) end = (-least - from.z) / way.z;
    vec3 to = from + end * way;
    bool flat_ = indirectIsOrthographic();
    return IndirectLine(indirectPlace(from), indirectPlace(to), end, flat_ ? 1.0 : -1.0 / from.z,
                        flat_ ? 1.0 : -1.0 / to.z);
}
#endif

// Marches from `from` along `way`, whose length is that of the ray; samples are moved back by
// `less` of a step. With INDIRECT_CHECKED a hit counts only within the sphere `center`: xyz, and w
// the radius.
IndirectHit indirectMarch(vec3 from, vec3 way, float less, vec4 center)
{
#ifdef INDIRECT_PICTURE
    IndirectLine line = indirectLine(from, way);
#endif
    for (int j = 1; j <= INDIRECT_STEPS; j++) {
        float s = (float(j) - less) / float(INDIRECT_STEPS);
#ifdef INDIRECT_PICTURE
        float over = mix(line.over0, line.over1, s), t = s * line.over1 / over * line.end;
        vec3 point = from + t * way;
        vec2 place = mix(line.a, line.b, s);
#else
        float t = s;
        vec3 point = from + t * way;
        if (!indirectIsOrthographic() && -point.z <= indirect_view.x) break;
        vec2 place = indirectPlace(point);
#endif
        if (!indirectIsShown(place)) break;
        ivec2 pixel = ivec2(place);
        float depth = texelFetch(indirect_depth, pixel, 0).x;
        if (depth <= 0.0 || !indirectIsBehind(point, depth)) continue;
#ifdef INDIRECT_CHECKED
        if (distance(indirectPoint(pixel, depth), center.xyz) > center.w) continue;
#endif
        return IndirectHit(t, pixel, vec3(0.0));
    }
    return IndirectHit(-1.0, ivec2(0), vec3(0.0));
}

// Data that all rays of a point share: its position, and the start of rays above it.
struct IndirectOrigin {
    vec3 point, from;
    float lift;
};

IndirectOrigin indirectOrigin(vec3 point, vec3 normal)
{
    float lift = indirectLift(point, normal);
    return IndirectOrigin(point, point + lift * normal, lift);
}

#ifdef INDIRECT_VOXELS
// Marches through voxels by the same steps (4.4): they know hidden surfaces, but no color. So the
// light is that of the pixel onto which the hit projects (5.3.4), whatever the pixel shows.
// Off-screen hits send no light; the thesis takes the color of the picture's border instead.
IndirectHit indirectMeet(IndirectOrigin origin, vec3 way, float less)
{
    float t;
    vec3 whole = indirect_reach.x * way;
    if (!voxelMarch(voxelPlace(origin.from), voxelDirection(whole), INDIRECT_STEPS, -less, t))
        return IndirectHit(-1.0, ivec2(0), vec3(0.0));
    vec3 end = origin.from + t * whole;
    vec2 place = indirectPlace(end);
    bool shown = (indirectIsOrthographic() || -end.z > indirect_view.x) && indirectIsShown(place);
    return IndirectHit(t, shown ? ivec2(place) : ivec2(-1), vec3(0.0));
}
#else
IndirectHit indirectMeet(IndirectOrigin origin, vec3 way, float less)
{
    return indirectMarch(origin.from, indirect_reach.x * way, less,
        vec4(origin.point, indirect_reach.x + origin.lift));
}
#endif
