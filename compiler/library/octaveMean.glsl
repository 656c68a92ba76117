// needs:
// What all octaves add where they are finer than the pixel: the noise's mean is 0.
float octaveMean(int count, float noiseRatio) {
    return 0.0;
}
