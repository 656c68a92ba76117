// needs:
// Derivative of stripes3 by q: the waves' difference between the box's ends over the edge; for edge
// < 1/2 from the transition in the box, if any. An edge <= 1e-6 gives 0. Relative error 1.2e-7.
vec3 stripesRate3(vec3 q, vec3 edges) {
    vec3 high = step(0.5, fract(q + 0.5 * edges));
    vec3 low = step(0.5, fract(q - 0.5 * edges));
    vec3 middle = abs(q - 0.5);
    vec3 holds = step(2.0 * min(min(q, 1.0 - q), middle), edges) * step(1.0e-6, edges);
    vec3 near = holds * (2.0 * step(0.25, middle) - 1.0);
    return mix(near, low - high, step(0.5, edges)) * 2.0 / max(edges, 1.0e-6);
}
