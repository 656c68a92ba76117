// needs:
// Inverse of encodeSpheremap, a unit vector for any e: with f = 4e - 2, d = f.f it is (f sqrt(1 - d/4), 1 - d/2).
// Outside the circle d = 4 of the encoded normals, where rounding may put one near -z, it is -z.
// Error 1e-6, within a degree of -z at most 3e-4.
vec3 decodeSpheremap(vec2 e) {
    vec2 f = 4.0 * e - 2.0;
    float d = min(dot(f, f), 4.0);
    return normalize(vec3(f * sqrt(1.0 - 0.25 * d), 1.0 - 0.5 * d));
}
