// needs: magnitudeLoss noiseStatistics
// Variance over the square that graniteFiltered leaves out, besides what the slope of its result says: of each octave of
// |noise|, 0.081 at most. Error 6e-8, and 1e-6 of it for narrow squares.
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
