// needs:
// Inverse of unormBits, in [0, 1].
float unormFromBits(uint code, int bits) {
    return float(code) / float((1 << bits) - 1);
}
