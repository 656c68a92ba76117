// needs:
// 1 / cosh^2 v. Error 2.6e-7 on llvmpipe.
float waveTanhSlope(float v) {
    float e = exp(-2.0 * min(abs(v), 40.0));
    return 4.0 * e / ((1.0 + e) * (1.0 + e));
}
