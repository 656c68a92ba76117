// needs: waveExpm1
// sinh v, |v| taken to at most 88. With t = e^|v| - 1 it is (t + t / (1 + t)) / 2, a sum of positive terms: error of waveExpm1.
float waveSinh(float v) {
    float t = waveExpm1(abs(v));
    float s = 0.5 * (t + t / (1.0 + t));
    return v < 0.0 ? -s : s;
}
