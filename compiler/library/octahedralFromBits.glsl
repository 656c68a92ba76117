// needs: octahedralFromWhole
// Inverse of octahedralBits: a unit vector for every code.
vec3 octahedralFromBits(uint code, int bits) {
    float scale = float((1 << (bits - 1)) - 1);
    vec2 whole = vec2(code & ((1u << bits) - 1u), code >> bits) - scale;
    return octahedralFromWhole(whole, bits);
}
