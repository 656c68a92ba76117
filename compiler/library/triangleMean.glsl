// needs:
// Box-filtered triangle wave (0 at integers v, 1 a quarter later). For edge < 1/2 from the nearest
// corner, without cancellation; else from the antiderivative. Error 3e-7. Edge 0 gives the point
// value.
float triangleMean(float v, float edge) {
    float t = fract(fract(v) - 0.25);
    float height = abs(4.0 * t - 2.0) - 1.0;
    float corner = 0.25 * (1.0 - abs(height));
    float over = max(0.5 * edge - corner, 0.0);
    float near = height - sign(height) * 4.0 * over * (over / max(edge, 1.0e-37));
    float a = fract(t - 0.5 * edge);
    float b = fract(t + 0.5 * edge);
    vec2 q = vec2(a, b);
    vec2 integral = q * (1.0 - 2.0 * q) + max(q - 0.5, 0.0) * (4.0 * q - 2.0);
    float far = (integral.y - integral.x) / max(edge, 0.25);
    return edge < 0.5 ? near : far;
}
