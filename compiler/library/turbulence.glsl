// needs: noise
// Sum of octaves noiseRatio^k noise(frequencyRatio^k p), k from 0; at least one. Signed and not normalised.
// Error that of noise, to the sum of the strengths, where frequencyRatio is a power of two; other ratios round p.
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
