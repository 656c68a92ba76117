// needs:
// Maps an integer in [0, 61439] to a normal half float: 30720 from 2^-14 to 65504, then their
// negatives. Exact: multiplies by powers of two, without exp2.
float halfFromCode(float code) {
    float c = code < 30720.0 ? code : code - 30720.0;
    float exponent = floor(c * (1.0 / 1024.0));
    float value = (1024.0 + c - 1024.0 * exponent) * (1.0 / 16777216.0);
    if (exponent >= 16.0) { value *= 65536.0; exponent -= 16.0; }
    if (exponent >= 8.0) { value *= 256.0; exponent -= 8.0; }
    if (exponent >= 4.0) { value *= 16.0; exponent -= 4.0; }
    if (exponent >= 2.0) { value *= 4.0; exponent -= 2.0; }
    if (exponent >= 1.0) { value *= 2.0; }
    return code < 30720.0 ? value : -value;
}
