// needs:
// Derivative of cubicMean by v: of its terms for edge < 1/2, else the wave's difference between the
// box's ends over the edge. An edge <= 1e-6 gives the point's derivative. Error 4.6e-7 max(1,
// |rate|).
float cubicRate(float v, float edge) {
    float t = fract(v);
    float q = abs(v - floor(v + 0.5));
    float over = max(0.5 * edge - q, 0.0);
    float jump = over > 0.0 && edge > 1.0e-6 ? (2.0 - 12.0 * over * over) / max(edge, 1.0e-6) : 0.0;
    float near = 12.0 * q * (1.0 - q) - edge * edge - jump;
    vec2 ends = fract(vec2(t - 0.5 * edge, t + 0.5 * edge));
    ends = ends * ends * (6.0 - 4.0 * ends);
    return edge < 0.5 ? near : (ends.y - ends.x) / max(edge, 0.25);
}
