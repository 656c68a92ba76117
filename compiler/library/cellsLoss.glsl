// needs:
// Fraction of a cellular noise's contrast that the mean over a square loses. The least-squares
// factor 1 / (1 + b x + c x^2) is rescaled as in octaveLoss, to reach 0 at a finite width. x: the
// square's edge, or its square.
float cellsLoss(float x, float b, float c) {
    float q = max(x * (b + c * x), 0.0);
    return min(1.43 * q / (1.0 + q), 1.0);
}
