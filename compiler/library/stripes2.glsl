// needs: stripesNear2
// Mean over boxes of waves that are 1 for q in [0, 1/2) and -1 in [1/2, 1), period 1; q in [0, 1]. For a box of 1/2 and more from the
// antiderivative. Error 2e-7.
vec2 stripes2(vec2 q, vec2 edges) {
    vec2 low = abs(fract(q - 0.5 * edges) - 0.5);
    vec2 high = abs(fract(q + 0.5 * edges) - 0.5);
    return mix(stripesNear2(q, edges), (low - high) / max(edges, 0.5), step(0.5, edges));
}
