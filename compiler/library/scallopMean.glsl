// needs: cosinePi sincMean sinePi
// Box-filtered 2 |sin(pi v)| - 1. For edge < 1/2: the sine's mean plus twice the sine over the part
// `over` beyond the cusp; else from the antiderivative. No cancellation; error 1.2e-6. Edge 0 gives
// the point value.
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
