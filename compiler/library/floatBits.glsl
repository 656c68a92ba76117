// needs:
// The 32 bits of v, clamped to finite floats.
uint floatBits(float v) {
    return floatBitsToUint(clamp(v, -3.4028234e38, 3.4028234e38));
}
