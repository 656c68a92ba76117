// needs: texel
// Derivative of carpenterRelief(s, uv, size) along a direction in uv. Exact between texels.
float reliefAlong(sampler2D s, vec2 uv, vec2 size, vec2 direction) {
    vec2 side = 1.0 - 2.0 * vec2(lessThan(uv, vec2(0.0)));
    vec2 at = fract(abs(uv)) * size;
    vec2 low = side * floor(at);
    vec2 weight = side * at - low;
    low += size * vec2(lessThan(low, vec2(0.0)));
    low -= size * step(size, low);
    vec2 high = low + 1.0;
    high -= size * step(size, high);
    float a = texel(s, low, size).r;
    float b = texel(s, vec2(high.x, low.y), size).r;
    float c = texel(s, vec2(low.x, high.y), size).r;
    float d = texel(s, high, size).r;
    vec2 rate = direction * size;
    return mix(b - a, d - c, weight.y) * rate.x + mix(c - a, d - b, weight.x) * rate.y;
}
