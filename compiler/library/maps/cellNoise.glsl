// needs: jenkins
// Random number in [0, 1] per unit cube (or unit square), as MaterialX's cellnoise3d and
// cellnoise2d. Coordinates are clamped to 2^24. Error 1e-7.
float cellNoise(vec3 p, int dimensions) {
    vec3 q = clamp(p, -16777216.0, 16777216.0) * vec3(1.0, 1.0, dimensions < 3 ? 0.0 : 1.0);
    return jenkins(floor(q), dimensions);
}
