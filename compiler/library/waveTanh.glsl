// needs: waveExpm1
// tanh v in [-1, 1]. With t = e^(-2|v|) - 1 it is -t / (2 + t), where the denominator is at least 1: error of waveExpm1,
// 5e-7 on llvmpipe.
float waveTanh(float v) {
    float t = waveExpm1(-2.0 * min(abs(v), 40.0));
    float s = -t / (2.0 + t);
    return v < 0.0 ? -s : s;
}
