// needs:
// Inverse of encodeOctahedral: a unit vector for any e in [-1, 1]^2. The length before normalize()
// is >= 1/sqrt(3).
vec3 decodeOctahedral(vec2 e) {
    float z = 1.0 - abs(e.x) - abs(e.y);
    float fold = max(-z, 0.0);
    return normalize(vec3(e.x + (e.x < 0.0 ? fold : -fold), e.y + (e.y < 0.0 ? fold : -fold), z));
}
