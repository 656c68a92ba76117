// needs: latticeResidue
// x^3 mod 761, a permutation of the residues since 761 = 2 (mod 3). For whole x in [0, 1521], exact.
vec4 latticePermute(vec4 x) {
    return latticeResidue(latticeResidue(x * x) * x);
}
