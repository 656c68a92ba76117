// needs: stripes3 stripesRate3
// Gradient of stripesAlong3 by q: the product rule in each of the four boxes. Error 1e-6 max(1,
// |gradient|).
vec3 stripesAlongRate3(vec3 q, vec3 along, vec3 edges) {
    vec3 sum = vec3(0.0);
    for (float at = -0.375; at < 0.5; at += 0.25) {
        vec3 x = fract(q + at * along);
        vec3 s = stripes3(x, edges);
        vec3 r = stripesRate3(x, edges);
        sum += r * s.yzx * s.zxy;
    }
    return 0.25 * sum;
}
