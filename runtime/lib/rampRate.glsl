// needs:
// Derivative of rampMean by v: the difference of the wave at its ends over its edge; an edge below 1/256 counts as that.
float rampRate(float v, float edge) {
    float width = max(edge, 1.0 / 256.0);
    float t = fract(v);
    vec2 q = vec2(t - 0.5 * width, t + 0.5 * width);
    vec2 ends = 2.0 * fract(q) - 1.0;
    return (ends.y - ends.x) / width;
}
