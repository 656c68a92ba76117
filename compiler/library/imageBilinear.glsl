// needs: texel
// Bilinear lookup with repeat. A texel's value is at its lower corner, not its center: the four
// texels from floor(size * fract(uv)) on. The first step() handles a fract() that rounds to 1.
// Error 8e-7.
vec4 imageBilinear(sampler2D s, vec2 uv, vec2 size) {
    vec2 at = fract(uv) * size;
    vec2 low = floor(at);
    vec2 weight = at - low;
    low -= size * step(size, low);
    vec2 high = low + 1.0;
    high -= size * step(size, high);
    return mix(mix(texel(s, low, size), texel(s, vec2(high.x, low.y), size), weight.x),
               mix(texel(s, vec2(low.x, high.y), size), texel(s, high, size), weight.x), weight.y);
}
