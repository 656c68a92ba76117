// needs: unormFromBits
// Inverse of rootBits, in [0, 1]. Error at most 1 / (2^bits - 1).
float rootFromBits(uint code, int bits) {
    float root = unormFromBits(code, bits);
    return root * root;
}
