// needs:
// Julia set of c = (cx, cy): z starts at 4 fract(p.xy) - 2. Returns the fraction of `iterations`
// steps z^2 + c with |z| <= 2, scaled to [-1, 1]. Rounding may change the count near the set's
// border.
float julia(vec3 p, int iterations, float cx, float cy) {
    vec2 z = 4.0 * fract(p.xy) - 2.0;
    int steps = 0;
    for (int k = 0; k < iterations; k++) {
        z = vec2(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y) + vec2(cx, cy);
        if (dot(z, z) > 4.0) break;
        steps++;
    }
    return 2.0 * float(steps) / max(float(iterations), 1.0) - 1.0;
}
