// The passes smooth and spread: means over pixels nearby that show the same surface, first along rows, then along columns; the second also makes pixels of the picture of
// those that are INDIRECT_COARSE wide. How much a pixel counts: by its place, flat over INDIRECT_FILTER to each side and half at the ends, so that of 2 all 16 shifts of
// a tile count alike; by how far its point is off the tangent plane, up to two pixels' width for each pixel that it is away; and by its normal.
uniform sampler2D smooth_source;

struct SmoothPlace {
    vec3 point, normal;
    float width; // of a pixel
};

float smoothWeight(SmoothPlace from, ivec2 pixel, float away)
{
    float depth = texelFetch(indirect_depth, pixel, 0).x;
    if (depth <= 0.0) return 0.0;
    float off = abs(dot(from.normal, indirectPoint(pixel, depth) - from.point));
    float near = 1.0 - off / (from.width * max(away, 1.0));
    if (near <= 0.0) return 0.0;
    float turned = max(dot(from.normal, indirectNormal(pixel)), 0.0);
    turned *= turned;
    turned *= turned;
    return near * turned * turned;
}

vec4 passPixel(ivec2 at)
{
#ifdef SMOOTH_SPREAD
    ivec2 pixel = at, middle = (at - INDIRECT_COARSE / 2) / INDIRECT_COARSE, low = ivec2(0, -INDIRECT_FILTER), high = ivec2(INDIRECT_COARSE > 1 ? 1 : 0, INDIRECT_FILTER);
    if (INDIRECT_COARSE > 1) high.y++;
#else
    ivec2 pixel = indirectPixel(at), middle = at, low = ivec2(-INDIRECT_FILTER, 0), high = ivec2(INDIRECT_FILTER, 0);
#endif
    float depth = texelFetch(indirect_depth, pixel, 0).x;
    if (depth <= 0.0) return vec4(0.0, 0.0, 0.0, 1.0);
    vec3 point = indirectPoint(pixel, depth);
    SmoothPlace from = SmoothPlace(point, indirectNormal(pixel), indirectPixelSize(point));
    ivec2 size = textureSize(smooth_source, 0);
    float reach = clamp(indirect_picture.w / (from.width * float(INDIRECT_COARSE)), min(2.0, float(INDIRECT_FILTER)), float(INDIRECT_FILTER));
    float sum = 0.0;
    vec4 mean = vec4(0.0), nearest = vec4(0.0, 0.0, 0.0, 1.0);
    for (int y = low.y; y <= high.y; y++)
        for (int x = low.x; x <= high.x; x++) {
            ivec2 source = middle + ivec2(x, y);
            if (any(lessThan(source, ivec2(0))) || any(greaterThanEqual(source, size))) continue;
            ivec2 shown = indirectPixel(source);
            vec2 apart = abs(vec2(shown - pixel)) / float(INDIRECT_COARSE);
            vec2 share = clamp(reach + 0.5 - apart, vec2(0.0), vec2(1.0));
            if (INDIRECT_COARSE > 1) share = clamp(max(reach, 0.5) + 0.5 - apart, vec2(0.0), vec2(1.0));
            vec4 value = texelFetch(smooth_source, source, 0);
            float weight = share.x * share.y * smoothWeight(from, shown, float(INDIRECT_COARSE) * (apart.x + apart.y));
            if (ivec2(x, y) == ivec2(0)) nearest = value;
            mean += weight * value;
            sum += weight;
        }
    return sum > 1e-3 ? mean / sum : nearest;
}
