// needs:
// Texel (i.x, i.y), taken at its centre; i is whole and inside the picture of `size` texels. Not for mipmapped pictures.
vec4 texel(sampler2D s, vec2 i, vec2 size) {
    return texture2D(s, (i + 0.5) / size);
}
