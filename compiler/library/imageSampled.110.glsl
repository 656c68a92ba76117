// needs:
// A picture by its sampler, which takes the footprint from the neighbouring pixels: not in branches. A texel's value stands at its
// lower corner, the sampler's at its centre. Below a texel a pixel the sampler's weights err by 1/256.
vec4 imageSampled(sampler2D s, vec2 uv, vec2 size) {
    return texture2D(s, uv + 0.5 / size);
}
