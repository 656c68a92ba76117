// needs:
// A residue modulo 761 less its middle is this much of 1.
const float latticeScale = 1.0 / 380.5;
