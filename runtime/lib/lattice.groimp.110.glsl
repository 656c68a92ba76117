// needs: latticeCorners latticeMix latticeTerms
// GroIMP's lattice noise, from its own tables: L_0 at p. About [-1, 1], standard deviation 1/4, period 65536 an axis.
float lattice(vec3 p) {
    vec3 cell = floor(p);
    vec3 d = p - cell;
    vec4 low, high;
    latticeCorners(cell, low, high);
    return latticeMix(latticeTerms(low, d), latticeTerms(high, d - vec3(0.0, 0.0, 1.0)), d);
}
