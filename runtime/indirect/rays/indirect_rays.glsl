// Means over a point's rays: rgb: light that they hit; a: occlusion. `open`: sum of the unoccluded
// directions. Preceded by indirectMeet(), which intersects a ray with the scene.
vec4 indirectAround(ivec2 pixel, IndirectShift shift, vec3 point, vec3 normal, out vec3 open)
{
    vec3 light = vec3(0.0), u, v;
    float kept = 0.0;
    open = vec3(0.0);
    indirectBasis(normal, u, v);
    IndirectOrigin origin = indirectOrigin(point, normal);
#ifdef INDIRECT_AROUND
    Around around = Around(vec3(0.0), vec3(0.0));
#endif
    for (int i = 0; i < INDIRECT_RAYS; i++) {
        vec3 local = indirectDirection(indirectSample(i, shift));
        vec3 way = local.x * u + local.y * v + local.z * normal;
        IndirectHit hit = indirectMeet(origin, way,
            INDIRECT_JITTER * fract(shift.at.z + shift.more.z + 0.618034 * float(i)));
        bool met = hit.t >= 0.0;
        float off = met ? indirectWeight(hit.t) : 0.0;
        kept += off;
#ifdef INDIRECT_AROUND
        aroundAdd(INDIRECT_SHARE(local.z) * aroundAt(way), 1.0 - off, around);
#endif
        open += met ? vec3(0.0) : way;
#ifdef INDIRECT_LIGHT
        float share = INDIRECT_SHARE(local.z);
        if (met && hit.pixel.x >= 0) light += share * indirectSent(hit.pixel, way);
        if (met) light += share * hit.sent;
#endif
    }
#ifdef INDIRECT_AROUND
    light += aroundBeside(around, 1.0 - kept / float(INDIRECT_RAYS));
#endif
    return vec4(light, kept) / float(INDIRECT_RAYS);
}
