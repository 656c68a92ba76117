// needs:
// Restricts v to half floats without special cases: clamped to 65504, 0 below the smallest normal,
// 2^-14. The render target rounds.
float plainHalf(float v) {
    float c = clamp(v, -65504.0, 65504.0);
    return abs(c) < 1.0 / 16384.0 ? 0.0 : c;
}
