// needs: lattice
// Noise in [-1, 1], standard deviation 1/2, not zero at whole p. About one sample in twenty is clamped.
float noise(vec3 p) {
    return clamp(2.0 * lattice(p), -1.0, 1.0);
}
