// needs: noiseStatistics octaveLoss
// Variance in the square that turbulenceFiltered removes, less the part that its gradient explains
// (4.73 / 12 of an octave's variance over an edge of 1, by its mean square slope). Error 2e-7 times
// the sum of amplitudes, relative 1e-6 for narrow squares: 1 - share^2 = loss (2 - loss).
float turbulenceVariance(int octaves, float frequencyRatio, float noiseRatio, float width) {
    int count = octaves > 1 ? octaves : 1;
    float strength = noiseVariance;
    float sum = 0.0;
    for (int k = 0; k < count; k++) {
        float loss = octaveLoss(width);
        float share = 1.0 - loss;
        float slope = min(width, 64.0) * noiseGrain;
        sum += strength * max(loss * (1.0 + share) - share * share * slope * slope * (4.73 / 12.0), 0.0);
        strength *= noiseRatio * noiseRatio;
        width = min(width * abs(frequencyRatio), 1.0e18);
    }
    return sum;
}
