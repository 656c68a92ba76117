// needs: latticeCorners latticeMix latticeScale latticeTerms
// Lattice noise at a point of a cell, d in [0, 1): at each corner a value and a gradient from a hash, smoothly interpolated.
// About [-1, 1], standard deviation 1/4, period 65536 an axis. Error below 1e-6 of the reference at the same floats.
float lattice(vec3 cell, vec3 d) {
    uvec4 low, high;
    latticeCorners(cell, low, high);
    return latticeMix(latticeTerms(low, d), latticeTerms(high, d - vec3(0.0, 0.0, 1.0)), d) * latticeScale;
}
