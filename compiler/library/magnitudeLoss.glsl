// needs: noiseStatistics
// The same of the noise's magnitude, whose creases are finer: q = 1.08 w^2 + 0.19 w^4, and it ends at 1.4 periods.
float magnitudeLoss(float width) {
    float periods = min(width, 64.0) * noiseGrain;
    float w = periods * periods;
    float q = w * (1.08 + 0.19 * w);
    return min(1.35 * q / (1.0 + q), 1.0);
}
