// needs: waveExpm1
// sinh v, |v| clamped to 88: (t + t / (1 + t)) / 2, t = e^|v| - 1, a sum of positive terms. Error
// of waveExpm1.
float waveSinh(float v) {
    float t = waveExpm1(abs(v));
    float s = 0.5 * (t + t / (1.0 + t));
    return v < 0.0 ? -s : s;
}
