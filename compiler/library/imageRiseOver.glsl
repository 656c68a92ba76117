// needs: imageRise imageRiseSampled
// imageRise of a picture with mipmaps, over the footprint that the changes of uv to the pixel's right and upper neighbour span. Up to
// a texel a pixel its texels are mixed here: the sampler's weights have eight bits, too few for a difference times the size. Far from
// the origin the sampler's steps would be lost, so whole turns are dropped; it is told the footprint, and sees no seam.
vec2 imageRiseOver(sampler2D s, vec2 uv, vec2 size, int lane, vec2 right, vec2 up) {
    vec2 across = right * size, along = up * size;
    if (max(dot(across, across), dot(along, along)) > 1.0)
        return imageRiseSampled(s, fract(uv), size, lane, right, up);
    return imageRise(s, uv, size, lane);
}
