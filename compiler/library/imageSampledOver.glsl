// needs:
// Samples an image over the footprint `right`, `up` (uv derivatives), texel values at the texels'
// lower corners (hence the half-texel offset). Under magnification the sampler's weights err by
// 1/256.
vec4 imageSampledOver(sampler2D s, vec2 uv, vec2 size, vec2 right, vec2 up) {
    return textureGrad(s, uv + 0.5 / size, right, up);
}
