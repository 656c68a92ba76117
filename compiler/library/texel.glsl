// needs:
// Texel (i.x, i.y) of the base level, whatever the sampler's state; i is whole and inside the picture.
vec4 texel(sampler2D s, vec2 i, vec2 size) {
    return texelFetch(s, ivec2(i), 0);
}
