// needs: latticeCorners latticeMix latticeTerms
// GroIMP's vector noise (L_0, L_8, L_16) at p: the same corners, the random table from another place on.
vec3 vectorNoise(vec3 p) {
    vec3 cell = floor(p);
    vec3 d = p - cell;
    vec3 e = d - vec3(0.0, 0.0, 1.0);
    ivec4 low, high;
    latticeCorners(cell, low, high);
    return vec3(latticeMix(latticeTerms(low, d), latticeTerms(high, e), d),
                latticeMix(latticeTerms(low + 8, d), latticeTerms(high + 8, e), d),
                latticeMix(latticeTerms(low + 16, d), latticeTerms(high + 16, e), d));
}
