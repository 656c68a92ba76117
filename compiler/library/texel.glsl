// needs:
// Texel (i.x, i.y) of mipmap level 0, independent of the sampler; i is integral and inside the
// image.
vec4 texel(sampler2D s, vec2 i, vec2 size) {
    return texelFetch(s, ivec2(i), 0);
}
