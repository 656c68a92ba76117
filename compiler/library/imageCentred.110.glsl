// needs:
// A picture by its sampler, a texel's value at its centre, where samplers have it. The footprint is that of the neighbouring pixels: not in branches.
// Below a texel a pixel the sampler's weights err by 1/256.
vec4 imageCentred(sampler2D s, vec2 uv) {
    return texture2D(s, uv);
}
