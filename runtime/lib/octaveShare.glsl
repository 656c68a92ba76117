// needs: noiseStatistics
// How much of an octave of noise is left in the mean over a square of a given edge, in periods of the octave: the best factor by
// least squares, measured and fitted to 0.02, less what makes it end at 3.3 periods. 1 for no width.
float octaveShare(float width) {
    float w = width * width * (noiseGrain * noiseGrain);
    return max(1.15 / (1.0 + w * (0.383 + 0.0467 * w)) - 0.15, 0.0);
}
