// A ray through what the picture shows (Thiedemann 2009, 4.3): INDIRECT_STEPS places along it; the
// first that lies behind the surface that its pixel shows is what it meets. What is beyond the
// picture's sides is not known: the ray ends there, and meets nothing. A place of the ray: its
// point, and where that is seen.
struct IndirectStep {
    vec3 point;
    vec2 place;
    float t;
};

#ifdef INDIRECT_PICTURE
// Even in the picture: of a segment whose ends are seen at a and b, what is seen at mix(a, b, s)
// lies at a share t of it, by the distances of the ends.
struct IndirectLine {
    vec2 a, b;
    float end, over0, over1; // share of the ray that lies before the eye; 1 / distance of the ends
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

// `from` is where it begins, `way` as long as it is; steps are `less` of one short of whole numbers
// of them. What it is behind counts if `most` from `center` at most.
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

// Data that all rays of a point share: where they begin.
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
// By the same steps in space, but of voxels (4.4): they know what is hidden, and no colour. So
// light is that of the pixel in which the hit would be seen (5.3.4), whatever that shows; where the
// thesis takes the colour of the picture's edge for what is beside it, there is none.
IndirectHit indirectMeet(IndirectOrigin origin, vec3 way, float less)
{
    float t;
    vec3 whole = indirect_reach.x * way;
    if (!voxelMarch(voxelPlace(origin.from), voxelDirection(whole), INDIRECT_STEPS, -less, t)) return IndirectHit(-1.0, ivec2(0), vec3(0.0));
    vec3 end = origin.from + t * whole;
    vec2 place = indirectPlace(end);
    bool shown = (indirectIsOrthographic() || -end.z > indirect_view.x) && indirectIsShown(place);
    return IndirectHit(t, shown ? ivec2(place) : ivec2(-1), vec3(0.0));
}
#else
IndirectHit indirectMeet(IndirectOrigin origin, vec3 way, float less)
{
    return indirectMarch(origin.from, indirect_reach.x * way, less, vec4(origin.point, indirect_reach.x + origin.lift));
}
#endif
