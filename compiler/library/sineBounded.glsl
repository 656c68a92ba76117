// needs: circleReduce circleSine
// Sine, in [-1, 1]. Error 1.5e-7 for |x| <= 1e5 on every driver; 6e-8 |x| above.
float sineBounded(float x) {
    vec2 part = circleReduce(x);
    return circleSine(part.x, part.y);
}
