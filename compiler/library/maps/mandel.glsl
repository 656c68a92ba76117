// needs:
// Mandelbrot set: c = 4 fract(p.xy) - 2, z starts at c. Returns the fraction of `iterations` steps
// z^2 + c with |z| <= 2, scaled to [-1, 1]. Rounding may change the count near the set's border.
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
