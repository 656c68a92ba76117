// needs: arcSmall
// Arc sine of x in [-1, 1]. Error 3e-7 on every driver.
float arcsineBounded(float x) {
    float a = min(abs(x), 1.0);
    float far = 1.57079633 - 2.0 * arcSmall(sqrt(0.5 - 0.5 * a));
    float near = arcSmall(min(a, 0.5));
    float value = a > 0.5 ? far : near;
    return x < 0.0 ? -value : value;
}
