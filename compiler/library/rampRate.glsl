// needs:
// Derivative of rampMean by v: 2, and below an edge of 1/2 the jump over the edge if the box holds it; above the difference of the
// wave at the box's ends over its edge. A box of at most 1e-6 is the point. Error 2.4e-7 to max(1, |rate|).
float rampRate(float v, float edge) {
    float t = fract(v);
    float distance = abs(v - floor(v + 0.5));
    float jump = 2.0 * distance < edge && edge > 1.0e-6 ? 2.0 / max(edge, 1.0e-6) : 0.0;
    float far = 2.0 * (fract(t + 0.5 * edge) - fract(t - 0.5 * edge)) / max(edge, 0.25);
    return edge < 0.5 ? 2.0 - jump : far;
}
