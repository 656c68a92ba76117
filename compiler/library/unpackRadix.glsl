// needs: codeFromHalf
// Inverse of packRadix: multiples of 1/246 and 1/247, rounded to nearest; in [0, 1]^2 for any
// value. The half step makes the division robust to rounding.
vec2 unpackRadix(float value) {
    float code = codeFromHalf(value);
    float y = floor((code + 0.5) * (1.0 / 247.0));
    return min(vec2(code - 247.0 * y, y) / vec2(246.0, 247.0), 1.0);
}
