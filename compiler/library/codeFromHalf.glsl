// needs:
// Inverse of halfFromCode: an integer in [0, 61439] for any value. Comparisons find the exponent;
// every step is exact.
float codeFromHalf(float value) {
    float v = clamp(abs(value) * 16384.0, 1.0, 1073217536.0);
    float exponent = 0.0;
    if (v >= 65536.0) { v *= 1.0 / 65536.0; exponent += 16.0; }
    if (v >= 256.0) { v *= 1.0 / 256.0; exponent += 8.0; }
    if (v >= 16.0) { v *= 1.0 / 16.0; exponent += 4.0; }
    if (v >= 4.0) { v *= 1.0 / 4.0; exponent += 2.0; }
    if (v >= 2.0) { v *= 1.0 / 2.0; exponent += 1.0; }
    return 1024.0 * exponent + floor(1024.0 * (v - 1.0)) + (value < 0.0 ? 30720.0 : 0.0);
}
