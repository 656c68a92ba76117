// Ambient occlusion by points (Thiedemann 2009, 6.2; Mittring 2007): samples in the half ball over
// the surface are occluded if they lie behind the depth buffer. A sample takes one lookup, where a
// ray takes one per step; but an occluder counts by the volume in it or hidden behind it, not by
// its solid angle. Uniform directions make samples uniform in the half ball: a wall at a share c of
// the radius has (1 - c)^2 (2 + c) / 4 of them behind it. Points find no light.
//
//     A wall at half the radius: (1/2)^2 (5/2) / 4 = 0.156 of the samples are behind the wall,
//         which uniform rays hit in 1/4 of their directions.
vec4 indirectAround(ivec2 pixel, IndirectShift shift, vec3 point, vec3 normal, out vec3 open)
{
    vec3 u, v, from = point + indirectLift(point, normal) * normal;
    float kept = 0.0;
    open = vec3(0.0);
    indirectBasis(normal, u, v);
    for (int i = 0; i < INDIRECT_RAYS; i++) {
        vec3 local = indirectDirection(indirectSample(i, shift)), way = local.x * u + local.y * v +
            local.z * normal;
        float s = pow(fract(indirect_samples[i].z + shift.at.z + shift.more.z), 1.0 / 3.0);
        vec3 place = from + s * indirect_reach.x * way;
        open += way;
#ifdef INDIRECT_VOXELS
        if (!voxelAt(voxelPlace(place))) continue;
#else
        vec2 at = indirectPlace(place);
        if ((!indirectIsOrthographic() && -place.z <= indirect_view.x) || !indirectIsShown(at))
            continue;
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
