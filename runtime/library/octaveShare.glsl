// needs: noiseStatistics
// How much of an octave of noise is left in the mean over a square of a given edge, in periods of the octave. The best factor by
// least squares is 1 / (1 + 0.383 w^2 + 0.0467 w^4), measured and fitted to 0.02; of it is taken what makes it end at 2 periods,
// where an octave has little to do with its mean: 1.43 / (1 + x) - 0.43, written so that it is 1 for no width, and nothing is left
// out there. A width of any size squares to a float.
float octaveShare(float width) {
    float periods = min(width, 64.0) * noiseGrain;
    float w = periods * periods;
    float x = w * (0.383 + 0.0467 * w);
    return max(1.0 - 1.43 * x / (1.0 + x), 0.0);
}
