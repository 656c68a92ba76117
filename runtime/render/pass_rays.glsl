// The pass rays: what a pixel's surface sees of its surroundings. rgb: light that comes by way of other surfaces, as the mean of what arrives, the cosine
// counted in (irradiance over pi); a: openness. Before it stand what unpacks the G-buffer, indirect_place.glsl, and the method's own.
#ifdef INDIRECT_LIGHT
uniform sampler2D indirect_light;

// What the surface of a pixel sends against a way; nothing if the side that is seen is turned away.
vec3 indirectSent(ivec2 pixel, vec3 way)
{
    return dot(indirectNormal(pixel), way) < 0.0 ? texelFetch(indirect_light, pixel, 0).xyz : vec3(0.0);
}
#endif

vec4 passPixel(ivec2 pixel)
{
    float depth = texelFetch(indirect_depth, pixel, 0).x;
    if (depth <= 0.0) return vec4(0.0, 0.0, 0.0, 1.0);
    vec3 point = indirectPoint(pixel, depth), normal = indirectNormal(pixel), light = vec3(0.0), open = vec3(0.0), u, v;
    vec3 shift = indirectShift(pixel);
    float lift = indirect_reach.y + indirect_reach.z * indirectPixelSize(point);
    vec3 from = point + lift * normal;
    float kept = 0.0;
    indirectBasis(normal, u, v);
    for (int i = 0; i < INDIRECT_RAYS; i++) {
        vec3 local = indirectDirection(fract(indirect_samples[i].xy + shift.xy));
        vec3 way = local.x * u + local.y * v + local.z * normal;
        float less = INDIRECT_JITTER * fract(shift.z + 0.618034 * float(i));
        IndirectHit hit = indirectMarch(from, indirect_reach.x * way, less, vec4(point, indirect_reach.x + lift));
        bool met = hit.t >= 0.0;
        kept += met ? indirectWeight(hit.t) : 0.0;
#ifdef INDIRECT_BENT
        open += met ? vec3(0.0) : way;
#endif
#ifdef INDIRECT_LIGHT
        float share = INDIRECT_SHARE(local.z);
        if (met) light += share * indirectSent(hit.pixel, way);
#endif
    }
#ifdef INDIRECT_BENT
    return vec4(dot(open, open) > 0.0 ? normalize(open) : normal, 1.0);
#else
    return vec4(light / float(INDIRECT_RAYS), max(1.0 - indirect_reach.w * kept / float(INDIRECT_RAYS), 0.0));
#endif
}
