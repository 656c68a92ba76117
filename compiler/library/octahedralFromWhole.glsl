// needs: decodeOctahedral
// Inverse of octahedralWhole: a unit vector. Angular error at most 242.5 / (2^bits - 2) degrees.
vec3 octahedralFromWhole(vec2 whole, int bits) {
    float scale = floor(exp2(float(bits - 1)) + 0.5) - 1.0;
    return decodeOctahedral(whole / scale);
}
