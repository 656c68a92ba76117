// needs: cosinePi sincMean sinePi
// Derivative of scallopMean by v: of its terms for edge < 1/2, else the wave's difference between
// the box's ends over the edge. Error 7e-6 (a sine near pi over a narrow edge).
float scallopRate(float v, float edge) {
    float t = fract(v);
    float over = max(0.5 * edge - min(t, 1.0 - t), 0.0);
    float cusp = 4.0 * sinePi(over) / max(edge, 1.0e-37);
    float near = 6.28318531 * cosinePi(t) * sincMean(3.14159265 * edge) - (t < 0.5 ? cusp : -cusp);
    vec2 ends = fract(vec2(t - 0.5 * edge, t + 0.5 * edge));
    return edge < 0.5 ? near : 2.0 * (sinePi(ends.y) - sinePi(ends.x)) / max(edge, 0.25);
}
