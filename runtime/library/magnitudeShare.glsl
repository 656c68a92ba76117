// needs: noiseStatistics
// The same of the noise's magnitude, whose creases are finer: 1 / (1 + 1.08 w^2 + 0.19 w^4), made to end at 1.4 periods.
float magnitudeShare(float width) {
    float periods = min(width, 64.0) * noiseGrain;
    float w = periods * periods;
    float x = w * (1.08 + 0.19 * w);
    return max(1.0 - 1.35 * x / (1.0 + x), 0.0);
}
