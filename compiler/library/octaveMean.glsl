// needs:
// Sum of the octaves' means: 0, because the noise's mean is 0.
float octaveMean(int count, float noiseRatio) {
    return 0.0;
}
