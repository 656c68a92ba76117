// needs: circleReduce circleSine
// Tangent, clamped to 1e7 at the poles. Relative error 3e-7, plus that of x.
float tangentBounded(float x) {
    vec2 part = circleReduce(x);
    float c = circleSine(part.x, part.y + 1.0);
    return circleSine(part.x, part.y) / (abs(c) < 1.0e-7 ? (c < 0.0 ? -1.0e-7 : 1.0e-7) : c);
}
