// Openness by points (Thiedemann 2009, 6.2; Mittring 2007): places in the half ball over the
// surface; what lies behind what its pixel shows is kept off. One look at the picture for each,
// where a ray takes as many as it has steps; but a thing counts by how much of the half ball is in
// it or hidden behind it, not by how much of the sky it covers. With directions that are even
// everywhere, places are even in the half ball: of a wall's share c of the radius away, (1 - c)^2
// (2 + c) / 4 are behind it. Points know nothing of light.
//
//     a wall at half the radius: (1/2)^2 (5/2) / 4 = 0.156 of the places are behind it, where rays
//         that are as even meet it in 1/4 of their directions
vec4 indirectAround(ivec2 pixel, IndirectShift shift, vec3 point, vec3 normal, out vec3 open)
{
    vec3 u, v, from = point + indirectLift(point, normal) * normal;
    float kept = 0.0;
    open = vec3(0.0);
    indirectBasis(normal, u, v);
    for (int i = 0; i < INDIRECT_RAYS; i++) {
        vec3 local = indirectDirection(indirectSample(i, shift)), way = local.x * u + local.y * v + local.z * normal;
        float s = pow(fract(indirect_samples[i].z + shift.at.z + shift.more.z), 1.0 / 3.0);
        vec3 place = from + s * indirect_reach.x * way;
        open += way;
#ifdef INDIRECT_VOXELS
        if (!voxelAt(voxelPlace(place))) continue;
#else
        vec2 at = indirectPlace(place);
        if ((!indirectIsOrthographic() && -place.z <= indirect_view.x) || !indirectIsShown(at)) continue;
        float depth = texelFetch(indirect_depth, ivec2(at), 0).x;
        if (depth <= 0.0 || !indirectIsBehind(place, depth)) continue;
#ifdef INDIRECT_CHECKED
        if (distance(indirectPoint(ivec2(at), depth), from) > indirect_reach.x) continue;
#endif
#endif
        open -= way;
        kept += indirectWeight(s);
    }
    return vec4(vec3(0.0), kept / float(INDIRECT_RAYS));
}
