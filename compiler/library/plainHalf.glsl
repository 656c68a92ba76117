// needs:
// v as a half float holds it without special cases: at most 65504 in size, and 0 below the least normal one, 2^-14. The target
// rounds it.
float plainHalf(float v) {
    float c = clamp(v, -65504.0, 65504.0);
    return abs(c) < 1.0 / 16384.0 ? 0.0 : c;
}
