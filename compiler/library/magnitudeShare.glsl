// needs: magnitudeLoss
// Fraction of |noise| that the mean over a square keeps.
float magnitudeShare(float width) {
    return 1.0 - magnitudeLoss(width);
}
