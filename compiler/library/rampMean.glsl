// needs:
// Box-filtered ramp 2 fract(v) - 1. For edge < 1/2 from the distance to the jump, without
// cancellation, else from the antiderivative. Error 2e-7. An edge <= 1e-6 gives the point value.
float rampMean(float v, float edge) {
    float t = fract(v);
    float distance = v - floor(v + 0.5); // fract() rounds just below a whole number
    float near = 2.0 * distance - clamp(2.0 * distance / max(edge, 1.0e-6), -1.0, 1.0);
    float a = fract(t - 0.5 * edge);
    float b = fract(t + 0.5 * edge);
    float far = (b * (b - 1.0) - a * (a - 1.0)) / max(edge, 0.25);
    return edge <= 1.0e-6 ? 2.0 * t - 1.0 : edge < 0.5 ? near : far;
}
