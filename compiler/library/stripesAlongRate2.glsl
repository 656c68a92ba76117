// needs: stripes2 stripesRate2
// Gradient of stripesAlong2 by q: of each of the four boxes, the rate of one lane by the means of the others.
// Error 1e-6 of it, of 1 at least.
vec2 stripesAlongRate2(vec2 q, vec2 along, vec2 edges) {
    vec2 sum = vec2(0.0);
    for (float at = -0.375; at < 0.5; at += 0.25) {
        vec2 x = fract(q + at * along);
        vec2 s = stripes2(x, edges);
        vec2 r = stripesRate2(x, edges);
        sum += r * s.yx;
    }
    return 0.25 * sum;
}
