// needs: cosinePi sincMean sinePi
// Derivative of scallopMean by v: below an edge of 1/2 that of its terms, above the difference of the wave at the box's ends over
// its edge. Error 7e-6, of a sine near pi over a narrow edge.
float scallopRate(float v, float edge) {
    float t = fract(v);
    float over = max(0.5 * edge - min(t, 1.0 - t), 0.0);
    float cusp = 4.0 * sinePi(over) / max(edge, 1.0e-37);
    float near = 6.28318531 * cosinePi(t) * sincMean(3.14159265 * edge) - (t < 0.5 ? cusp : -cusp);
    vec2 ends = fract(vec2(t - 0.5 * edge, t + 0.5 * edge));
    return edge < 0.5 ? near : 2.0 * (sinePi(ends.y) - sinePi(ends.x)) / max(edge, 0.25);
}
