// needs: noiseStatistics
// Fraction of a noise octave that the mean over a square of edge `width` (periods) loses. The
// least-squares factor is 1 / (1 + q), q = 0.383 w^2 + 0.0467 w^4, fitted to 0.02; 1.43 / (1 + q) -
// 0.43 remains, so an octave is dropped at 2 periods. Exactly 0 for width 0, accurate for narrow
// squares; min() avoids overflow.
float octaveLoss(float width) {
    float periods = min(width, 64.0) * noiseGrain;
    float w = periods * periods;
    float q = w * (0.383 + 0.0467 * w);
    return min(1.43 * q / (1.0 + q), 1.0);
}
