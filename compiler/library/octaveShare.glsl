// needs: octaveLoss
// How much of an octave of noise is left in the mean over a square of a given edge; 1 for no width.
float octaveShare(float width) {
    return 1.0 - octaveLoss(width);
}
