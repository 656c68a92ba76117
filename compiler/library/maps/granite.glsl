// needs: noise
// Six octaves of |noise(4 2^k p)| - 1/2 with amplitudes 2^-k; in [-63/64, 63/64]. Error 4e-6.
float granite(vec3 p) {
    vec3 q = 4.0 * p;
    float strength = 1.0;
    float sum = 0.0;
    for (int k = 0; k < 6; k++) {
        sum += strength * (abs(noise(q)) - 0.5);
        strength *= 0.5;
        q *= 2.0;
    }
    return sum;
}
