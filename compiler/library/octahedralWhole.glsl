// needs: encodeOctahedral
// Quantizes a unit normal to two integers in [-s, s], s = 2^(bits-1) - 1, on the octahedron. The
// axes are exact. A half float holds them exactly for bits <= 12. floor() makes exp2 exact for bits
// <= 16.
vec2 octahedralWhole(vec3 n, int bits) {
    float scale = floor(exp2(float(bits - 1)) + 0.5) - 1.0;
    return floor(encodeOctahedral(n) * scale + 0.5);
}
