// needs:
// Box-filtered cubic wave t^2 (6 - 4t) - 1, t = fract(v), of period 1. For edge < 1/2: the
// polynomial's mean plus a correction for the part `over` beyond the jump, where the next period is
// 2 - 12 s^2 higher at distance s. Else differences of the antiderivative 2t^3 - t^4 - t. No
// cancellation; error 4e-7. An edge <= 1e-6 gives the point value.
float cubicMean(float v, float edge) {
    float t = fract(v);
    float distance = v - floor(v + 0.5); // fract() rounds just below a whole number
    float q = abs(distance);
    float point = q * q * (6.0 - 4.0 * q) - 1.0;
    float over = max(0.5 * edge - q, 0.0);
    float jump = (2.0 - 4.0 * over * over) * (over / max(edge, 1.0e-6));
    float near = edge <= 1.0e-6 ? point : point + 0.5 * edge * edge * (1.0 - 2.0 * q) + jump;
    float a = fract(t - 0.5 * edge);
    float b = fract(t + 0.5 * edge);
    float far = (b * (b * b * (2.0 - b) - 1.0) - a * (a * a * (2.0 - a) - 1.0)) / max(edge, 0.25);
    return edge >= 0.5 ? far : distance >= 0.0 ? near : -near;
}
