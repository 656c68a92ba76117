// needs: cellsCell3 cellsHash3 cellsNumber
// Random number in [0, 1] of the unit cube that contains p. Discontinuous at cube faces; exact
// elsewhere.
float cellRandom(vec3 p) {
    vec3 cell, d;
    cellsCell3(p, vec3(0.0), cell, d);
    return cellsNumber(cellsHash3(cell, vec3(0.0)));
}
