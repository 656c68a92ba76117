// needs: latticeCell noiseStatistics octaveMean octaveShare vectorNoise
// vectorTurbulence(p + rest, ...), filtered over a square of edge `width`: octaves fade to their
// mean, half of noise's per component, and are skipped once faded. Error of turbulence.
vec3 vectorTurbulenceFiltered(vec3 p, vec3 rest, int octaves, float frequencyRatio, float noiseRatio, float width) {
    int count = octaves > 1 ? octaves : 1;
    float strength = 1.0;
    vec3 sum = vec3(0.5 * octaveMean(count, noiseRatio));
    for (int k = 0; k < count; k++) {
        float share = octaveShare(width);
        if (share <= 0.0 && abs(frequencyRatio) >= 1.0) break;
        vec3 cell, d;
        latticeCell(p, rest, cell, d);
        sum += strength * share * (vectorNoise(cell, d) - 0.5 * noiseMean);
        strength *= noiseRatio;
        p *= frequencyRatio;
        rest *= frequencyRatio;
        width *= abs(frequencyRatio);
    }
    return sum;
}
