// needs:
// Texel (i.x, i.y), sampled at its center; i is integral and inside the image of `size` texels. Not
// for mipmapped images.
vec4 texel(sampler2D s, vec2 i, vec2 size) {
    return texture2D(s, (i + 0.5) / size);
}
