// needs:
// Sine of r + quarter * pi / 2, r in [-0.8, 0.8]. The polynomials' error is 2e-9 before rounding.
float circleSine(float r, float quarter) {
    float square = r * r;
    float s = r + r * square * (-0.166666507 + square * (8.33197866e-3 + square * -1.94956357e-4));
    float c = 1.0 - 0.5 * square + square * square * (0.0416666469 + square * (-1.38873675e-3 + square * 2.44384508e-5));
    float value = abs(mod(quarter, 2.0)) < 0.5 ? s : c;
    return mod(quarter, 4.0) < 1.5 ? value : -value;
}
