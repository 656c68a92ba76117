// needs: texel
// Texel (i.x, i.y), i integral, with an address mode: 1 mirror, up to two texels outside the mirror
// image; 2 clamp to edge; 3 border of 0.
vec4 texelBeyond(sampler2D s, vec2 i, vec2 size, int address) {
    vec2 turn = i - 2.0 * size * step(2.0 * size, i);
    vec2 place = clamp(address == 1 ? min(turn, 2.0 * size - 1.0 - turn) : i, vec2(0.0), size - 1.0);
    return address == 3 && place != i ? vec4(0.0) : texel(s, place, size);
}
