// needs: texel
// Texel (i.x, i.y), i whole, of a picture that goes on beyond its edges: of address 1 mirrored, up to two texels beyond its mirror
// image; 2 as its outermost texels; 3 as 0.
vec4 texelBeyond(sampler2D s, vec2 i, vec2 size, int address) {
    vec2 turn = i - 2.0 * size * step(2.0 * size, i);
    vec2 place = clamp(address == 1 ? min(turn, 2.0 * size - 1.0 - turn) : i, vec2(0.0), size - 1.0);
    return address == 3 && place != i ? vec4(0.0) : texel(s, place, size);
}
