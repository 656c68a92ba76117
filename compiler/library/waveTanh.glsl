// needs: waveExpm1
// tanh v in [-1, 1]: -t / (2 + t), t = e^(-2|v|) - 1; the denominator is >= 1. Error of waveExpm1,
// 5e-7 on llvmpipe.
float waveTanh(float v) {
    float t = waveExpm1(-2.0 * min(abs(v), 40.0));
    float s = -t / (2.0 + t);
    return v < 0.0 ? -s : s;
}
