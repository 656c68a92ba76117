// needs: texel
// Samples a synthetic single-channel texture, repeated and bilinear as in GroIMP: size * uv is
// truncated toward zero, so a negative coordinate extrapolates with a negative weight. fract()
// removes whole periods exactly.
float carpenterRelief(sampler2D s, vec2 uv, vec2 size) {
    vec2 side = 1.0 - 2.0 * vec2(lessThan(uv, vec2(0.0)));
    vec2 at = fract(abs(uv)) * size;
    vec2 low = side * floor(at);
    vec2 weight = side * at - low;
    low += size * vec2(lessThan(low, vec2(0.0)));
    low -= size * step(size, low);
    vec2 high = low + 1.0;
    high -= size * step(size, high);
    return mix(mix(texel(s, low, size).r, texel(s, vec2(high.x, low.y), size).r, weight.x),
               mix(texel(s, vec2(low.x, high.y), size).r, texel(s, high, size).r, weight.x), weight.y);
}
