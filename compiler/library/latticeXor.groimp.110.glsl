// needs:
// Bitwise xor of integers in [0, 65536), per byte by a 256 x 256 table, x ^ y at (x, y).
uniform sampler2D matc_xor;
float latticeXor(float a, float b) {
    vec2 ab = vec2(a, b);
    vec2 high = floor(ab * (1.0 / 256.0));
    vec2 low = ab - 256.0 * high;
    vec2 bytes = vec2(texture2D(matc_xor, (low + 0.5) * (1.0 / 256.0)).r, texture2D(matc_xor, (high + 0.5) * (1.0 / 256.0)).r);
    return dot(floor(bytes * 255.0 + 0.5), vec2(1.0, 256.0));
}
