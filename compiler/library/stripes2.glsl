// needs: stripesNear2
// Box-filtered square waves of period 1, component-wise: 1 for q in [0, 1/2), -1 in [1/2, 1); q in
// [0, 1]. For edge >= 1/2 from the antiderivative. Error 2e-7.
vec2 stripes2(vec2 q, vec2 edges) {
    vec2 low = abs(fract(q - 0.5 * edges) - 0.5);
    vec2 high = abs(fract(q + 0.5 * edges) - 0.5);
    return mix(stripesNear2(q, edges), (low - high) / max(edges, 0.5), step(0.5, edges));
}
