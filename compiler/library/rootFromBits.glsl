// needs: unormFromBits
// Inverse of rootBits, in [0, 1], at most 1 / (2^bits - 1) from what was packed.
float rootFromBits(uint code, int bits) {
    float root = unormFromBits(code, bits);
    return root * root;
}
