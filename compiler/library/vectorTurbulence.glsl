// needs: vectorNoise
// Sum of octaves noiseRatio^k vectorNoise(frequencyRatio^k p), k from 0; at least one. Signed, not
// normalized. Error of turbulence.
vec3 vectorTurbulence(vec3 p, int octaves, float frequencyRatio, float noiseRatio) {
    int count = octaves > 1 ? octaves : 1;
    float strength = 1.0;
    vec3 sum = vec3(0.0);
    for (int k = 0; k < count; k++) {
        vec3 cell = floor(p);
        sum += strength * vectorNoise(cell, p - cell);
        strength *= noiseRatio;
        p *= frequencyRatio;
    }
    return sum;
}
