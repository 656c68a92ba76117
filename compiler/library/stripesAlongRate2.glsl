// needs: stripes2 stripesRate2
// Gradient of stripesAlong2 by q: the product rule in each of the four boxes. Error 1e-6 max(1,
// |gradient|).
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
