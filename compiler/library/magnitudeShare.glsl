// needs: magnitudeLoss
// How much of an octave of the noise's magnitude is left.
float magnitudeShare(float width) {
    return 1.0 - magnitudeLoss(width);
}
