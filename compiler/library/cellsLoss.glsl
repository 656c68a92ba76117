// needs:
// How much of a cells' value the mean over a square loses, which is 1 / (1 + b x + c x^2) of it by least squares: as octaveLoss, it ends where that has
// little to do with the mean. x: the square's edge, or its square.
float cellsLoss(float x, float b, float c) {
    float q = max(x * (b + c * x), 0.0);
    return min(1.43 * q / (1.0 + q), 1.0);
}
