// needs: latticeCorners latticeMix latticeTerms
// Lattice noise: at each corner of p's cell a value and a gradient from a hash in float arithmetic, smoothly interpolated.
// About [-1, 1], standard deviation 1/4, period 65536 an axis. Error below 1e-6 of the reference at the same float p.
float lattice(vec3 p) {
    vec3 cell = floor(p);
    vec3 d = p - cell;
    vec4 low, high;
    latticeCorners(cell, low, high);
    return latticeMix(latticeTerms(low, d), latticeTerms(high, d - vec3(0.0, 0.0, 1.0)), d) * (1.0 / 380.5);
}
