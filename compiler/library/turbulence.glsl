// needs: noise
// Sum of octaves noiseRatio^k noise(frequencyRatio^k p), k from 0; at least one. Signed, not
// normalized. Error of noise times the sum of amplitudes if frequencyRatio is a power of two; other
// ratios round p.
float turbulence(vec3 p, int octaves, float frequencyRatio, float noiseRatio) {
    int count = octaves > 1 ? octaves : 1;
    float strength = 1.0;
    float sum = 0.0;
    for (int k = 0; k < count; k++) {
        sum += strength * noise(p);
        strength *= noiseRatio;
        p *= frequencyRatio;
    }
    return sum;
}
