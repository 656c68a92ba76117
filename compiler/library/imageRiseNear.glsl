// needs: imageRise imageRiseSampled
// imageRise under magnification, because the sampler's 8-bit weights are too coarse for a
// difference times the size; else the given difference `shown`. Outside 65536 texels a float cannot
// step 1/256 texel: whole periods are dropped, and the explicit footprint avoids a seam.
vec2 imageRiseNear(sampler2D s, vec2 uv, vec2 size, int lane, vec2 right, vec2 up, vec2 shown) {
    vec2 across = right * size, along = up * size, far = abs(uv) * size;
    if (max(dot(across, across), dot(along, along)) <= 1.0)
        return imageRise(s, uv, size, lane);
    if (max(far.x, far.y) > 65536.0)
        return imageRiseSampled(s, fract(uv), size, lane, right, up);
    return shown;
}
