// needs: cosinePi sincMean sinePi
// Mean of 2 |sin(pi v)| - 1 over a box. Below an edge of 1/2 that of the sine and, of the part `over` that reaches across the cusp,
// twice the sine; above from the antiderivative. Neither cancels: error 1.2e-6. A box without an edge is the point.
float scallopMean(float v, float edge) {
    float t = fract(v);
    float over = max(0.5 * edge - min(t, 1.0 - t), 0.0);
    float sine = sinePi(0.5 * over);
    float cusp = 2.54647909 * sine * (sine / max(edge, 1.0e-37));
    float near = 2.0 * sinePi(t) * sincMean(3.14159265 * edge) - 1.0 + cusp;
    vec2 q = vec2(t - 0.5 * edge, t + 0.5 * edge);
    vec2 turns = floor(q);
    vec2 part = q - turns;
    vec2 integral = (1.0 - vec2(cosinePi(part.x), cosinePi(part.y))) * (2.0 / 3.14159265);
    float far = (integral.y - integral.x + (turns.y - turns.x) * (4.0 / 3.14159265)) / max(edge, 0.25) - 1.0;
    return edge < 0.5 ? near : far;
}
