// needs: octaveLoss
// Fraction of a noise octave that remains in the mean over a square of edge `width` (periods); 1
// for 0.
float octaveShare(float width) {
    return 1.0 - octaveLoss(width);
}
