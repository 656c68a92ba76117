// needs:
// sin(x / 2) / (x / 2), x >= 0: attenuation of a sine by a box of edge x. Error 2e-7.
float sincMean(float x) {
    float h = 0.5 * x;
    return h < 1.0e-2 ? 1.0 - h * h * (1.0 / 6.0) : sin(h) / max(h, 1.0e-2);
}
