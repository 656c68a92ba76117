// needs:
// Mean over boxes of waves that are 1 for q in [0, 1/2) and -1 in [1/2, 1), period 1; q in [0, 1]. For a box below 1/2 from the
// distance to the nearest edge, which does not cancel: error 1e-7 at any width. For a wider one from the antiderivative: 2e-7.
// A box below 1e-6 is the point, which at an edge belongs to the upper side.
vec2 stripes2(vec2 q, vec2 edges) {
    vec2 outer = step(0.25, abs(q - 0.5));
    vec2 distance = mix(0.5 - q, q - step(0.5, q), outer);
    vec2 point = 1.0 - 2.0 * step(0.5, q);
    vec2 near = mix(clamp(2.0 * distance / edges, -1.0, 1.0), point, step(edges, vec2(1.0e-6)));
    vec2 far = (abs(fract(q - 0.5 * edges) - 0.5) - abs(fract(q + 0.5 * edges) - 0.5)) / max(edges, 0.25);
    return mix(near, far, step(0.5, edges));
}
