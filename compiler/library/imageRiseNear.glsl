// needs: imageRise imageRiseSampled
// imageRise up to a texel a pixel, where the sampler's weights have eight bits, too few for a difference times the size; from there
// on the rise of what it shows. Beyond 65536 texels floats keep a step of a texel to less than 1/256: there whole turns are dropped, and
// the sampler is told the footprint, so that it sees no seam.
vec2 imageRiseNear(sampler2D s, vec2 uv, vec2 size, int lane, vec2 right, vec2 up, vec2 shown) {
    vec2 across = right * size, along = up * size, far = abs(uv) * size;
    if (max(dot(across, across), dot(along, along)) <= 1.0)
        return imageRise(s, uv, size, lane);
    if (max(far.x, far.y) > 65536.0)
        return imageRiseSampled(s, fract(uv), size, lane, right, up);
    return shown;
}
