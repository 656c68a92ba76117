// needs: latticeResidue
// x^3 mod 761, a permutation since 761 = 2 (mod 3). Exact for integers x in [0, 1521].
vec4 latticePermute(vec4 x) {
    return latticeResidue(latticeResidue(x * x) * x);
}
