// needs: cellsCell3 cellsHash3 cellsNumber
// The random number in [0, 1] of the cube between whole numbers in which p lies. Jumps at their sides; exact elsewhere.
float cellRandom(vec3 p) {
    vec3 cell, d;
    cellsCell3(p, vec3(0.0), cell, d);
    return cellsNumber(cellsHash3(cell, vec3(0.0)));
}
