// needs: texel
// Nearest lookup with repeat: texel floor(size * fract(uv)). min() handles a fract() that rounds to
// 1.
vec4 imageNearest(sampler2D s, vec2 uv, vec2 size) {
    return texel(s, min(floor(fract(uv) * size), size - 1.0), size);
}
