// needs:
// Inverse of encodeSpheremap, a unit vector for any e: (f sqrt(1 - d/4), 1 - d/2), f = 4e - 2, d =
// f.f. Returns -z outside the valid circle d <= 4, where rounding may move a normal near -z. Error
// 1e-6, within a degree of -z at most 3e-4.
vec3 decodeSpheremap(vec2 e) {
    vec2 f = 4.0 * e - 2.0;
    float d = min(dot(f, f), 4.0);
    return normalize(vec3(f * sqrt(1.0 - 0.25 * d), 1.0 - 0.5 * d));
}
