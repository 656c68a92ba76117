// needs:
// x mod 761, exact for integers x in [0, 2.4e6]: (x + 1/2) / 761 is at least 6.5e-4 from an
// integer, and rounding moves the quotient by less than 3.8e-4.
vec4 latticeResidue(vec4 x) {
    return x - 761.0 * floor((x + 0.5) * (1.0 / 761.0));
}
