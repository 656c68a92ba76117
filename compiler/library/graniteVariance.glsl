// needs: magnitudeLoss noiseStatistics
// Variance in the square that graniteFiltered removes, less the part that its gradient explains. An
// octave of |noise| has at most 0.081. Error 6e-8, relative 1e-6 for narrow squares.
float graniteVariance(float width) {
    float strength = 0.081;
    float sum = 0.0;
    width *= 4.0;
    for (int k = 0; k < 6; k++) {
        float loss = magnitudeLoss(width);
        float share = 1.0 - loss;
        float slope = min(width, 64.0) * noiseGrain;
        sum += strength * max(loss * (1.0 + share) - share * share * slope * slope * (14.6 / 12.0), 0.0);
        strength *= 0.25;
        width *= 2.0;
    }
    return sum;
}
