// needs: latticeResidue
// Values and gradients of a face's four corners, times 380.5: affine functions of the hash modulo
// 761.
void latticeNumbers(vec4 hash, out vec4 value, out vec4 x, out vec4 y, out vec4 z) {
    value = hash - 380.0;
    x = latticeResidue(hash * 209.0 + 97.0) - 380.0;
    y = latticeResidue(hash * 304.0 + 211.0) - 380.0;
    z = latticeResidue(hash * 373.0 + 523.0) - 380.0;
}
