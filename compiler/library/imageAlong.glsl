// needs: texel
// Derivative of imageBilinear(s, uv, size) along a direction in uv. Exact between texels.
vec4 imageAlong(sampler2D s, vec2 uv, vec2 size, vec2 direction) {
    vec2 at = fract(uv) * size;
    vec2 low = floor(at);
    vec2 weight = at - low;
    low -= size * step(size, low);
    vec2 high = low + 1.0;
    high -= size * step(size, high);
    vec4 a = texel(s, low, size);
    vec4 b = texel(s, vec2(high.x, low.y), size);
    vec4 c = texel(s, vec2(low.x, high.y), size);
    vec4 d = texel(s, high, size);
    vec2 rate = direction * size;
    return mix(b - a, d - c, weight.y) * rate.x + mix(c - a, d - b, weight.x) * rate.y;
}
