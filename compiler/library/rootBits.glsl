// needs: unormBits
// Quantizes sqrt(v), v clamped to [0, 1], to `bits` bits: finer steps near 0, like perceived
// lightness.
uint rootBits(float v, int bits) {
    return unormBits(sqrt(clamp(v, 0.0, 1.0)), bits);
}
