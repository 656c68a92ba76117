// needs:
// Derivative of rampMean by v: for edge < 1/2, 2 minus the jump over the edge if the box has the
// jump; else the wave's difference between the box's ends over the edge. An edge <= 1e-6 gives the
// point's derivative. Error 2.4e-7 max(1, |rate|).
float rampRate(float v, float edge) {
    float t = fract(v);
    float distance = abs(v - floor(v + 0.5));
    float jump = 2.0 * distance < edge && edge > 1.0e-6 ? 2.0 / max(edge, 1.0e-6) : 0.0;
    float far = 2.0 * (fract(t + 0.5 * edge) - fract(t - 0.5 * edge)) / max(edge, 0.25);
    return edge < 0.5 ? 2.0 - jump : far;
}
