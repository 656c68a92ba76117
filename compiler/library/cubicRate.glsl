// needs:
// Derivative of cubicMean by v: below an edge of 1/2 that of its terms, above the difference of the wave at the box's ends over its
// edge. A box of at most 1e-6 is the point. Error 4.6e-7 to max(1, |rate|).
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
