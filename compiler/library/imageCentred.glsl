// needs:
// Samples an image, texel values at texel centers. Uses implicit derivatives: not in branches.
// Under magnification the sampler's weights err by 1/256.
vec4 imageCentred(sampler2D s, vec2 uv) {
    return texture(s, uv);
}
