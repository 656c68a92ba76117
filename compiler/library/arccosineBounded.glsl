// needs: arcSmall
// Arc cosine of x in [-1, 1]. Error 4e-7 on every driver, relative near x = 1.
float arccosineBounded(float x) {
    float a = min(abs(x), 1.0);
    float far = 2.0 * arcSmall(sqrt(0.5 - 0.5 * a));
    float near = 1.57079633 - arcSmall(min(a, 0.5));
    float value = a > 0.5 ? far : near;
    return x < 0.0 ? 3.14159265 - value : value;
}
