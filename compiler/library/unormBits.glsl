// needs:
// Quantizes v, clamped to [0, 1], to `bits` <= 16 bits, rounding to nearest.
uint unormBits(float v, int bits) {
    return uint(floor(clamp(v, 0.0, 1.0) * float((1 << bits) - 1) + 0.5));
}
