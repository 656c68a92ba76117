// needs:
// Mandelbrot set: c = 4 (fraction of p.xy) - 2, z from c on; the share of `iterations` steps z^2 + c that stay within
// |z| <= 2, laid over [-1, 1]. Next to the set's edge rounding may change the number of steps.
float mandel(vec3 p, int iterations) {
    vec2 c = 4.0 * fract(p.xy) - 2.0;
    vec2 z = c;
    int steps = 0;
    for (int k = 0; k < iterations; k++) {
        z = vec2(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y) + c;
        if (dot(z, z) > 4.0) break;
        steps++;
    }
    return 2.0 * float(steps) / max(float(iterations), 1.0) - 1.0;
}
