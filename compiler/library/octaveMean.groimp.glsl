// needs: noiseStatistics
// What all octaves add where they are finer than the pixel: the noise's mean, as strong as each.
float octaveMean(int count, float noiseRatio) {
    float strength = noiseMean;
    float sum = 0.0;
    for (int k = 0; k < count; k++) {
        sum += strength;
        strength *= noiseRatio;
    }
    return sum;
}
