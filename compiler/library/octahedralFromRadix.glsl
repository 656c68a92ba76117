// needs: codeFromHalf decodeOctahedral
// Inverse of octahedralRadix: a unit vector for any value. Angular error at most 0.99 degrees.
vec3 octahedralFromRadix(float value) {
    float code = codeFromHalf(value);
    float y = floor((code + 0.5) * (1.0 / 247.0));
    return decodeOctahedral(min((vec2(code - 247.0 * y, y) - 123.0) / 123.0, 1.0));
}
