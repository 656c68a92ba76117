// needs: stripesNear3
// Box-filtered square waves of period 1, component-wise: 1 for q in [0, 1/2), -1 in [1/2, 1); q in
// [0, 1]. For edge >= 1/2 from the antiderivative. Error 2e-7.
vec3 stripes3(vec3 q, vec3 edges) {
    vec3 low = abs(fract(q - 0.5 * edges) - 0.5);
    vec3 high = abs(fract(q + 0.5 * edges) - 0.5);
    return mix(stripesNear3(q, edges), (low - high) / max(edges, 0.5), step(0.5, edges));
}
