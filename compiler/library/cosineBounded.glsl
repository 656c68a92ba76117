// needs: circleReduce circleSine
// Cosine, in [-1, 1]. Error 1.5e-7 for |x| up to 1e5, whatever the driver; beyond that 6e-8 |x|.
float cosineBounded(float x) {
    vec2 part = circleReduce(x);
    return circleSine(part.x, part.y + 1.0);
}
