// needs: noiseLong noiseStatistics octaveMean octaveShare
// turbulence(p + rest, ...), filtered over a square of edge `width`: octaves fade to their mean and
// are skipped once faded. Error of turbulence.
float turbulenceFiltered(vec3 p, vec3 rest, int octaves, float frequencyRatio, float noiseRatio, float width) {
    int count = octaves > 1 ? octaves : 1;
    float strength = 1.0;
    float sum = octaveMean(count, noiseRatio);
    for (int k = 0; k < count; k++) {
        float share = octaveShare(width);
        if (share <= 0.0 && abs(frequencyRatio) >= 1.0) break;
        sum += strength * share * (noiseLong(p, rest) - noiseMean);
        strength *= noiseRatio;
        p *= frequencyRatio;
        rest *= frequencyRatio;
        width *= abs(frequencyRatio);
    }
    return sum;
}
