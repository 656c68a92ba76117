// needs:
// Inverse of sharedExponentBits: exact for every code.
vec3 sharedExponentFromBits(uint code, int bits) {
    uint mask = (1u << bits) - 1u;
    uvec3 m = uvec3(code, code >> bits, code >> (2 * bits)) & mask;
    return vec3(m) * uintBitsToFloat((code >> (3 * bits)) + uint(112 - bits) << 23);
}
