// needs: imageRise imageRiseSampled
// imageRise of a mipmapped image over the footprint of the pixel's uv derivatives `right` and `up`.
// Under magnification texels are mixed here: the sampler's 8-bit weights are too coarse for a
// difference times the size. Whole periods are dropped to keep steps precise; the explicit
// footprint avoids a seam.
vec2 imageRiseOver(sampler2D s, vec2 uv, vec2 size, int lane, vec2 right, vec2 up) {
    vec2 across = right * size, along = up * size;
    if (max(dot(across, across), dot(along, along)) > 1.0)
        return imageRiseSampled(s, fract(uv), size, lane, right, up);
    return imageRise(s, uv, size, lane);
}
