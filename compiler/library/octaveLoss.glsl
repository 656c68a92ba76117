// needs: noiseStatistics
// How much of an octave of noise the mean over a square of a given edge loses, in periods of the octave. The best factor by least
// squares is 1 / (1 + q), q = 0.383 w^2 + 0.0467 w^4, measured and fitted to 0.02; of it is taken what makes it end at 2 periods, where
// an octave has little to do with its mean: 1.43 / (1 + q) - 0.43 are left, and these are lost. Exactly 0 for no width, and good to
// its last bits for a narrow one; a width of any size squares to a float.
float octaveLoss(float width) {
    float periods = min(width, 64.0) * noiseGrain;
    float w = periods * periods;
    float q = w * (0.383 + 0.0467 * w);
    return min(1.43 * q / (1.0 + q), 1.0);
}
