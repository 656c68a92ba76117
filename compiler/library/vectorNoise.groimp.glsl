// needs: latticeCorners latticeMix latticeNext latticeScale latticeTerms
// Three lattice noises at position d in a cell: x is lattice(cell, d); y and z use further hashes.
vec3 vectorNoise(vec3 cell, vec3 d) {
    vec3 e = d - vec3(0.0, 0.0, 1.0);
    vec3 sum;
    ivec4 low, high;
    latticeCorners(cell, low, high);
    sum.x = latticeMix(latticeTerms(low, d), latticeTerms(high, e), d);
    low = latticeNext(low);
    high = latticeNext(high);
    sum.y = latticeMix(latticeTerms(low, d), latticeTerms(high, e), d);
    low = latticeNext(low);
    high = latticeNext(high);
    sum.z = latticeMix(latticeTerms(low, d), latticeTerms(high, e), d);
    return sum * latticeScale;
}
