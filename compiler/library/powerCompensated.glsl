// needs: splitHigh
// x^n for n >= 1 by repeated squaring of (value, rounding error): within 1 ULP while the result is
// finite.
vec2 powerProduct(vec2 a, vec2 b) {
    float product = a.x * b.x;
    vec3 high = splitHigh(vec3(a.x, b.x, 0.0));
    float al = a.x - high.x;
    float bl = b.x - high.y;
    float error = ((high.x * high.y - product) + high.x * bl + al * high.y) + al * bl;
    return vec2(product, error + (a.x * b.y + a.y * b.x));
}

float powerCompensated(float x, int n) {
    vec2 power = vec2(x, 0.0);
    vec2 result = vec2(1.0, 0.0);
    for (int i = 0; i < 7; i++) {
        int rest = n / 2;
        if (n - 2 * rest == 1)
            result = powerProduct(result, power);
        n = rest;
        if (n < 1) break;
        power = powerProduct(power, power);
    }
    return abs(result.x) < 1.0e37 ? result.x + result.y : result.x;
}
