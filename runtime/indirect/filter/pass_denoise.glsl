// The passes denoise and upsample: edge-avoiding means over nearby pixels of the same surface,
// first along rows, then along columns. The second also upsamples from pixels that are
// INDIRECT_COARSE wide.
//
// A pixel's weight is a product of three factors. By position: constant over INDIRECT_FILTER pixels
// to each side and half at the ends, so that with a radius of 2 all 16 shifts of a tile have equal
// weight. By distance from the tangent plane: falls to 0 at one pixel width per pixel of distance.
// By normal: the fourth power of the cosine.
uniform sampler2D smooth_source;

struct SmoothPlace {
    vec3 point, normal;
    float width; // width of a pixel at the point
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

// Returns the bounds of the picture in the source texture.
ivec2 smoothLow() { return ivec2(indirectLow()) / INDIRECT_COARSE; }
ivec2 smoothSize() { return (ivec2(indirect_picture.xy) + INDIRECT_COARSE - 1) / INDIRECT_COARSE; }

#ifdef SMOOTH_ATROUS
// A-trous ("with holes") filter at the resolution of the rays. Level i takes 5 x 5 pixels that are
// 2^i apart, with the weights of the B3 spline, 1 4 6 4 1 over 16, so that a few levels of 25 taps
// reach as far as one filter of thousands.
//
// From level 1 on a pixel's weight falls with the difference of its value, measured in noise: the
// standard deviation of the rays' results over 3 x 3 pixels of the same surface. Level 0 reduces
// that noise by the root of the sum of its squared weights, 70 / 256; each further level halves it.
// Larger differences are detail, not noise. Level 0 takes no such weight: there values differ by
// noise alone, and rejecting them would darken the mean. Light and ambient occlusion are weighted
// separately.
//
//     Neighbors of 0.7, 0.5, 0.6: a deviation of 0.08; on level 1 of 0.022. A pixel that differs
//         by 0.05 has the weight exp(-0.05 / (SMOOTH_NOISE 0.022)), a half.
uniform sampler2D smooth_rays; // the rays' results, not denoised
uniform float smooth_level;

const float SMOOTH_NOISE = 3.0; // tolerated difference in standard deviations

// Returns the mean component of light, and ambient occlusion.
vec2 smoothComponents(vec4 value) { return vec2(dot(value.xyz, vec3(1.0 / 3.0)), value.w); }

vec2 smoothNoise(SmoothPlace from, ivec2 at)
{
    vec2 sum = vec2(0.0), squares = vec2(0.0);
    float weights = 0.0;
    for (int y = -1; y <= 1; y++)
        for (int x = -1; x <= 1; x++) {
            ivec2 beside = clamp(at + ivec2(x, y), smoothLow(), smoothSize() - 1);
            float weight = smoothWeight(from, indirectPixel(beside),
                float(INDIRECT_COARSE * (abs(x) + abs(y))));
            vec2 components = smoothComponents(texelFetch(smooth_rays, beside, 0));
            sum += weight * components;
            squares += weight * components * components;
            weights += weight;
        }
    vec2 mean = sum / max(weights, 1e-3);
    float left = 70.0 / 128.0 * exp2(-smooth_level);
    return left * sqrt(max(squares / max(weights, 1e-3) - mean * mean, vec2(0.0)));
}

vec4 passPixel(ivec2 at)
{
    const float kernel[3] = float[3](0.375, 0.25, 0.0625);
    ivec2 pixel = indirectPixel(at);
    float depth = texelFetch(indirect_depth, pixel, 0).x;
    if (depth <= 0.0) return vec4(0.0, 0.0, 0.0, 1.0);
    vec3 point = indirectPoint(pixel, depth);
    SmoothPlace from = SmoothPlace(point, indirectNormal(pixel), indirectPixelSize(point));
    vec4 middle = texelFetch(smooth_source, at, 0), mean = vec4(0.0);
    vec2 sum = vec2(0.0), noise = vec2(1.0);
    if (smooth_level > 0.5) noise = SMOOTH_NOISE * smoothNoise(from, at) + 1e-4;
    int apart = 1 << int(smooth_level);
    for (int y = -2; y <= 2; y++)
        for (int x = -2; x <= 2; x++) {
            ivec2 beside = at + apart * ivec2(x, y);
            if (any(lessThan(beside, smoothLow())) || any(greaterThanEqual(beside, smoothSize())))
                continue;
            vec4 value = texelFetch(smooth_source, beside, 0);
            float same = kernel[abs(x)] * kernel[abs(y)] *
                (x == 0 && y == 0 ? 1.0 : smoothWeight(from, indirectPixel(beside),
                float(INDIRECT_COARSE * apart * (abs(x) + abs(y)))));
            vec2 weight = vec2(same);
            if (smooth_level > 0.5)
                weight *= exp(-abs(smoothComponents(value) - smoothComponents(middle)) / noise);
            mean += weight.xxxy * value;
            sum += weight;
        }
    return mean / max(sum.xxxy, vec4(1e-6));
}
#else
vec4 passPixel(ivec2 at)
{
#ifdef SMOOTH_SPREAD
    const int more = INDIRECT_COARSE > 1 ? 1 : 0;
    const ivec2 low = ivec2(0, -INDIRECT_FILTER),
        count = ivec2(1 + more, 2 * INDIRECT_FILTER + 1 + more);
    ivec2 pixel = at, middle = (at - INDIRECT_COARSE / 2) / INDIRECT_COARSE;
#else
    const ivec2 low = ivec2(-INDIRECT_FILTER, 0), count = ivec2(2 * INDIRECT_FILTER + 1, 1);
    ivec2 pixel = indirectPixel(at), middle = at;
#endif
    float depth = texelFetch(indirect_depth, pixel, 0).x;
    if (depth <= 0.0) return vec4(0.0, 0.0, 0.0, 1.0);
    vec3 point = indirectPoint(pixel, depth);
    SmoothPlace from = SmoothPlace(point, indirectNormal(pixel), indirectPixelSize(point));
    ivec2 first = smoothLow(), size = smoothSize();
    float reach = clamp(indirect_picture.w / (from.width * float(INDIRECT_COARSE)),
        min(2.0, float(INDIRECT_FILTER)), float(INDIRECT_FILTER));
    float sum = 0.0;
    vec4 mean = vec4(0.0), nearest = vec4(0.0, 0.0, 0.0, 1.0);
    for (int i = 0; i < count.x * count.y; i++) {
        ivec2 beside = low + ivec2(i % count.x, i / count.x), source = middle + beside;
        if (any(lessThan(source, first)) || any(greaterThanEqual(source, size))) continue;
        ivec2 shown = indirectPixel(source);
        vec2 apart = abs(vec2(shown - pixel)) / float(INDIRECT_COARSE);
        vec2 share = clamp(reach + 0.5 - apart, vec2(0.0), vec2(1.0));
        if (INDIRECT_COARSE > 1) share = clamp(max(reach, 0.5) + 0.5 - apart, vec2(0.0), vec2(1.0));
        vec4 value = texelFetch(smooth_source, source, 0);
        float weight = share.x * share.y *
            smoothWeight(from, shown, float(INDIRECT_COARSE) * (apart.x + apart.y));
        if (beside == ivec2(0)) nearest = value;
        mean += weight * value;
        sum += weight;
    }
    return sum > 1e-3 ? mean / sum : nearest;
}
#endif
