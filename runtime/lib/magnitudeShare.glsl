// needs: noiseStatistics
// The same of the noise's magnitude, whose creases are finer; ends at 2.2 periods.
float magnitudeShare(float width) {
    float w = width * width * (noiseGrain * noiseGrain);
    return max(1.1 / (1.0 + w * (1.08 + 0.19 * w)) - 0.1, 0.0);
}
