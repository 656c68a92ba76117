// needs: texelBeyond texelsRise imageRiseSampled
// imageRiseOver for a sampler that mirrors (address 1), clamps (2), or has a zero border (3). Error
// 6e-7 size.
vec3 imageRiseBeyondRow(sampler2D s, vec3 x, float y, vec2 size, int lane, int address) {
    return vec3(texelBeyond(s, vec2(x.x, y), size, address)[lane], texelBeyond(s, vec2(x.y, y), size, address)[lane],
                texelBeyond(s, vec2(x.z, y), size, address)[lane]);
}

vec2 imageRiseBeyond(sampler2D s, vec2 uv, vec2 size, int lane, int address, vec2 right, vec2 up) {
    vec2 across = right * size, along = up * size;
    vec2 turn = address == 1 ? fract(uv * 0.5) * 2.0 : uv; // as imageRiseOver's, two at a time
    if (max(dot(across, across), dot(along, along)) > 1.0)
        return imageRiseSampled(s, turn, size, lane, right, up);
    vec2 at = turn * size;
    vec2 low = floor(at);
    vec3 x = low.x + vec3(0.0, 1.0, 2.0);
    return texelsRise(imageRiseBeyondRow(s, x, low.y, size, lane, address), imageRiseBeyondRow(s, x, low.y + 1.0, size, lane, address),
                      imageRiseBeyondRow(s, x, low.y + 2.0, size, lane, address), at - low) * size;
}
