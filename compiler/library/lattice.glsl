// needs: latticeCorners latticeMix latticeScale latticeTerms
// Lattice noise at position d in [0, 1) in a cell: hashed value and gradient per corner, smoothly
// interpolated. About [-1, 1], standard deviation 1/4, period 65536 per axis. Error 1e-6.
float lattice(vec3 cell, vec3 d) {
    uvec4 low, high;
    latticeCorners(cell, low, high);
    return latticeMix(latticeTerms(low, d), latticeTerms(high, d - vec3(0.0, 0.0, 1.0)), d) * latticeScale;
}
