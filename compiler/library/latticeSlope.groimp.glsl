// needs: latticeCorners latticeRise latticeScale
// Gradient of lattice(cell, d), then its value. Error 2e-6 in each lane.
vec4 latticeSlope(vec3 cell, vec3 d) {
    ivec4 low, high;
    latticeCorners(cell, low, high);
    return latticeRise(low, high, d) * latticeScale;
}
