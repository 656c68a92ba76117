// needs:
// e^v, v clamped to at most 88. Relative error of exp: 4e-6 at 88 on llvmpipe.
float waveExp(float v) {
    return exp(min(v, 88.0));
}
