// needs:
// Mean over boxes of waves that are 1 for q in [0, 1/2) and -1 in [1/2, 1), period 1; q in [0, 1]. For a box below 1/2 from the
// distance to the nearest edge, which does not cancel: error 1e-7 at any width. For a wider one from the antiderivative: 2e-7.
// A box below 1e-6 is the point, which at an edge belongs to the upper side.
vec3 stripes3(vec3 q, vec3 edges) {
    vec3 outer = step(0.25, abs(q - 0.5));
    vec3 distance = mix(0.5 - q, q - step(0.5, q), outer);
    vec3 point = 1.0 - 2.0 * step(0.5, q);
    vec3 near = mix(clamp(2.0 * distance / edges, -1.0, 1.0), point, step(edges, vec3(1.0e-6)));
    vec3 far = (abs(fract(q - 0.5 * edges) - 0.5) - abs(fract(q + 0.5 * edges) - 0.5)) / max(edges, 0.25);
    return mix(near, far, step(0.5, edges));
}
