// needs:
// Scales a centered residue modulo 761 to [-1, 1].
const float latticeScale = 1.0 / 380.5;
