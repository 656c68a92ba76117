// needs: texel
// Texel floor(size * fraction of uv) of a picture of `size` texels. The min is for a fraction that rounds up to 1.
vec4 imageNearest(sampler2D s, vec2 uv, vec2 size) {
    return texel(s, min(floor(fract(uv) * size), size - 1.0), size);
}
