// needs:
// Arc tangent. Relative error 3e-7 on every driver.
float arctangentBounded(float x) {
    float a = abs(x);
    bool steep = a > 2.41421356;
    bool middle = a > 0.414213562;
    float t = steep ? -1.0 / max(a, 1.0) : middle ? (a - 1.0) / (a + 1.0) : a;
    float offset = steep ? 1.57079633 : middle ? 0.785398163 : 0.0;
    float square = t * t;
    float value = offset + (t + t * square * (-0.333327567 + square * (0.199718792 + square * (-0.138244532
                + square * 0.0790259681))));
    return x < 0.0 ? -value : value;
}
