// needs:
// Phong exponent of a shininess x: -2 / ln y, y = x (2 - x), at most 65504; 0 for y <= 0. Relative
// error 8e-7. Near x = 1 a series avoids cancellation: with w = (1 - x)^2 and s = w / (2 - w), ln y
// is -2 (s + s^3/3 + s^5/5 + s^7/7 + ...); for w <= 1/4 the remainder is below 2e-8 relative.
float phongExponent(float x) {
    float y = x * (2.0 - x);
    float w = min((1.0 - x) * (1.0 - x), 0.25);
    float s = w / (2.0 - w);
    float s2 = s * s;
    float series = s * (1.0 + s2 * (1.0 / 3.0 + s2 * (1.0 / 5.0 + s2 * (1.0 / 7.0))));
    float logarithm = -0.5 * log(clamp(y, 1.17549435e-38, 0.76));
    float exponent = min(1.0 / max(y < 0.75 ? logarithm : series, 1.0 / 65504.0), 65504.0);
    return y > 0.0 ? exponent : 0.0;
}
