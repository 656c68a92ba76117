// needs: noiseSlope noiseStatistics octaveMean octaveShare
// Gradient by p (xyz) and value (w) of turbulenceFiltered(p, rest, ...). Error 5e-6 times the sum
// of noiseRatio^k frequencyRatio^k.
vec4 turbulenceGradient(vec3 p, vec3 rest, int octaves, float frequencyRatio, float noiseRatio, float width) {
    int count = octaves > 1 ? octaves : 1;
    float strength = 1.0;
    float frequency = 1.0;
    vec4 sum = vec4(0.0, 0.0, 0.0, octaveMean(count, noiseRatio));
    for (int k = 0; k < count; k++) {
        float share = octaveShare(width);
        if (share <= 0.0 && abs(frequencyRatio) >= 1.0) break;
        vec4 octave = noiseSlope(p, rest);
        sum += strength * share * vec4(frequency * octave.xyz, octave.w - noiseMean);
        strength *= noiseRatio;
        frequency *= frequencyRatio;
        p *= frequencyRatio;
        rest *= frequencyRatio;
        width *= abs(frequencyRatio);
    }
    return sum;
}
