// needs: circleReduce circleSine
// Sine, in [-1, 1]. Error 1.5e-7 for |x| up to 1e5, whatever the driver; beyond that 6e-8 |x|.
float sineBounded(float x) {
    vec2 part = circleReduce(x);
    return circleSine(part.x, part.y);
}
