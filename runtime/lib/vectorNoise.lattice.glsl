// needs: latticeCorners latticeMix latticeNext latticeTerms
// Three lattice noises at p; the first is lattice(p), the others take further hashes of the same corners.
vec3 vectorNoise(vec3 p) {
    vec3 cell = floor(p);
    vec3 d = p - cell;
    vec3 e = d - vec3(0.0, 0.0, 1.0);
    vec3 sum;
    uvec4 low, high;
    latticeCorners(cell, low, high);
    sum.x = latticeMix(latticeTerms(low, d), latticeTerms(high, e), d);
    low = latticeNext(low);
    high = latticeNext(high);
    sum.y = latticeMix(latticeTerms(low, d), latticeTerms(high, e), d);
    low = latticeNext(low);
    high = latticeNext(high);
    sum.z = latticeMix(latticeTerms(low, d), latticeTerms(high, e), d);
    return sum * (1.0 / 2147483648.0);
}
