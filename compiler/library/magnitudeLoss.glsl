// needs: noiseStatistics
// Fraction of an octave of |noise| that the mean over a square loses, see octaveLoss: q = 1.08 w^2
// + 0.19 w^4; 1 at 1.4 periods.
float magnitudeLoss(float width) {
    float periods = min(width, 64.0) * noiseGrain;
    float w = periods * periods;
    float q = w * (1.08 + 0.19 * w);
    return min(1.35 * q / (1.0 + q), 1.0);
}
