// needs:
// e^v - 1, v clamped to [-88, 88], where the result is finite. Relative error 2e-7 for |v| < 1/2
// (Taylor series to v^8, remainder 1e-8), else 2.5 times exp's. No cancellation.
float waveExpm1(float v) {
    v = clamp(v, -88.0, 88.0);
    float series = v * (1.0 + v * (1.0 / 2.0 + v * (1.0 / 6.0 + v * (1.0 / 24.0 + v * (1.0 / 120.0
                 + v * (1.0 / 720.0 + v * (1.0 / 5040.0 + v * (1.0 / 40320.0))))))));
    return abs(v) < 0.5 ? series : exp(v) - 1.0;
}
