// needs:
// Mean of 2 |sin(pi v)| - 1 over a box. Below an edge of 1/32 the cusp is averaged and the rest taken at v: error 8e-4; above from
// the antiderivative: error 8e-6.
float scallopMean(float v, float edge) {
    float t = fract(v);
    float distance = min(t, 1.0 - t);
    float over = max(0.5 * edge - distance, 0.0);
    float near = 2.0 * sin(3.14159265 * t) - 1.0 + 6.28318531 * over * over / edge;
    vec2 q = vec2(t - 0.5 * edge, t + 0.5 * edge);
    vec2 turns = floor(q);
    vec2 part = q - turns;
    vec2 integral = (1.0 - cos(3.14159265 * part)) * (2.0 / 3.14159265);
    float far = (integral.y - integral.x + (turns.y - turns.x) * (4.0 / 3.14159265)) / max(edge, 1.0 / 64.0) - 1.0;
    return edge < 1.0 / 32.0 ? near : far;
}
