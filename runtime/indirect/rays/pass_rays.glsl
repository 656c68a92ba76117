// The pass rays: ambient occlusion and indirect light of a pixel. rgb: indirect light, as the
// cosine-weighted mean of incoming radiance (irradiance / pi); a: ambient occlusion. Preceded by
// the unpacking of the G-buffer, indirect_place.glsl, and the method's GLSL with indirectAround().
#ifdef INDIRECT_SETS
uniform float indirect_set; // number of the set of rays
#endif

vec4 passPixel(ivec2 small)
{
    ivec2 pixel = indirectPixel(small);
    float depth = texelFetch(indirect_depth, pixel, 0).x;
    if (depth <= 0.0) return vec4(0.0, 0.0, 0.0, 1.0);
    vec3 point = indirectPoint(pixel, depth), normal = indirectNormal(pixel), open = vec3(0.0);
    vec4 around = vec4(0.0);
    int first = 0;
#ifdef INDIRECT_SETS
    first = int(indirect_set);
#endif
    for (int i = 0; i < INDIRECT_SAMPLES; i++) {
        vec3 ways;
        around += indirectAround(pixel, indirectShift(pixel, first + i), point, normal, ways) /
            float(INDIRECT_SAMPLES);
        open += ways;
    }
#ifdef INDIRECT_BENT
    return vec4(dot(open, open) > 0.0 ? normalize(open) : normal, 1.0);
#else
    return vec4(around.xyz, max(1.0 - indirect_reach.w * around.w, 0.0));
#endif
}
