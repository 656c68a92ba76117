// needs:
// Inverse of floatBits.
float floatFromBits(uint code) {
    return uintBitsToFloat(code);
}
