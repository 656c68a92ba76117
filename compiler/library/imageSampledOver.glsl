// needs:
// A picture by its sampler over the footprint that the changes of uv to the pixel's right and upper neighbour span. A texel's value
// stands at its lower corner, the sampler's at its centre. Below a texel a pixel the sampler's weights err by 1/256.
vec4 imageSampledOver(sampler2D s, vec2 uv, vec2 size, vec2 right, vec2 up) {
    return textureGrad(s, uv + 0.5 / size, right, up);
}
