// needs: latticeCorners latticeMix latticePermute latticeTerms
// Three lattice noises at p; the first is lattice(p), the others take further hashes of the same corners.
vec3 vectorNoise(vec3 p) {
    vec3 cell = floor(p);
    vec3 d = p - cell;
    vec3 e = d - vec3(0.0, 0.0, 1.0);
    vec3 sum;
    vec4 low, high;
    latticeCorners(cell, low, high);
    sum.x = latticeMix(latticeTerms(low, d), latticeTerms(high, e), d);
    low = latticePermute(low + 17.0);
    high = latticePermute(high + 17.0);
    sum.y = latticeMix(latticeTerms(low, d), latticeTerms(high, e), d);
    low = latticePermute(low + 17.0);
    high = latticePermute(high + 17.0);
    sum.z = latticeMix(latticeTerms(low, d), latticeTerms(high, e), d);
    return sum * (1.0 / 380.5);
}
