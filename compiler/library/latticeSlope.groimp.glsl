// needs: latticeCorners latticeRise latticeScale
// Gradient (xyz) and value (w) of lattice(cell, d). Error 2e-6.
vec4 latticeSlope(vec3 cell, vec3 d) {
    ivec4 low, high;
    latticeCorners(cell, low, high);
    return latticeRise(low, high, d) * latticeScale;
}
