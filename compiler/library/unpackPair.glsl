// needs:
// Inverse of packPair: multiples of 1 / 127.5, at most 1 / 127.5 below the packed values; [0, 127 /
// 127.5] for any value. Comparisons find the exponent exactly; floor(log2(v)) may be one too low at
// a power of two.
vec2 unpackPair(float value) {
    float v = clamp(value, 1.0, 65504.0);
    float exponent = 0.0;
    if (v >= 256.0) { v *= 1.0 / 256.0; exponent += 8.0; }
    if (v >= 16.0) { v *= 1.0 / 16.0; exponent += 4.0; }
    if (v >= 4.0) { v *= 1.0 / 4.0; exponent += 2.0; }
    if (v >= 2.0) { v *= 1.0 / 2.0; exponent += 1.0; }
    float m = 8.0 * (v - 1.0);
    return vec2(floor(m) + 8.0 * exponent, 128.0 * fract(m)) * (1.0 / 127.5);
}
