// needs:
// Samples an image, texel values at the texels' lower corners (hence the half-texel offset). Uses
// implicit derivatives: not in branches. Under magnification the sampler's weights err by 1/256.
vec4 imageSampled(sampler2D s, vec2 uv, vec2 size) {
    return texture(s, uv + 0.5 / size);
}
