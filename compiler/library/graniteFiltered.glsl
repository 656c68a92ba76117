// needs: magnitudeShare noiseLong noiseStatistics
// granite(p + rest), filtered over a square of edge `width`: octaves fade to their mean and are
// skipped once faded. Error 3.2e-6.
float graniteFiltered(vec3 p, vec3 rest, float width) {
    float frequency = 4.0;
    float strength = 1.0;
    float sum = (noiseMagnitude - 0.5) * (63.0 / 32.0);
    for (int k = 0; k < 6; k++) {
        float share = magnitudeShare(frequency * width);
        if (share <= 0.0) break;
        sum += strength * share * (abs(noiseLong(frequency * p, frequency * rest)) - noiseMagnitude);
        strength *= 0.5;
        frequency *= 2.0;
    }
    return sum;
}
