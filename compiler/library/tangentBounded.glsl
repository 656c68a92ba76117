// needs: circleReduce circleSine
// Tangent. Relative error 3e-7 where that of x allows it; at its poles it is cut at 1e7.
float tangentBounded(float x) {
    vec2 part = circleReduce(x);
    float c = circleSine(part.x, part.y + 1.0);
    return circleSine(part.x, part.y) / (abs(c) < 1.0e-7 ? (c < 0.0 ? -1.0e-7 : 1.0e-7) : c);
}
