// needs: sine3
// Component-wise sin(x) / x, x >= 0; 1 - x^2 / 6 near 0 avoids loss of digits. Error 3e-7.
vec3 sinc(vec3 x) {
    vec3 near = 1.0 - x * x * (1.0 / 6.0);
    vec3 far = sine3(x) / max(x, 1.0e-2);
    return mix(far, near, step(x, vec3(1.0e-2)));
}
