// needs: noiseStatistics
// Sum of the octaves' means: noiseMean times each octave's amplitude.
float octaveMean(int count, float noiseRatio) {
    float strength = noiseMean;
    float sum = 0.0;
    for (int k = 0; k < count; k++) {
        sum += strength;
        strength *= noiseRatio;
    }
    return sum;
}
