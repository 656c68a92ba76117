// needs:
// x mod 761 for whole x in [0, 2.4e6], exact: (x + 1/2) / 761 is at least 6.5e-4 away from a whole number, and rounding moves
// it by less than 3.8e-4.
vec4 latticeResidue(vec4 x) {
    return x - 761.0 * floor((x + 0.5) * (1.0 / 761.0));
}
