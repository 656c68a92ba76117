// needs: noiseStatistics octaveLoss
// Variance over the square that turbulenceFiltered leaves out, besides what the slope of its result says: of each octave, the
// noise's own at most (4.73 / 12 of it is what its mean square slope makes over an edge of 1). Error 2e-7 to the sum of the
// strengths, and 1e-6 of it for narrow squares: 1 - share^2 is loss (2 - loss).
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
