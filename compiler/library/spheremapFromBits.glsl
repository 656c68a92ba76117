// needs: decodeSpheremap unormFromBits
// Inverse of spheremapBits: a unit vector for every code.
vec3 spheremapFromBits(uint code, int bits) {
    uint x = code & ((1u << bits) - 1u);
    return decodeSpheremap(vec2(unormFromBits(x, bits), unormFromBits(code >> bits, bits)));
}
