// needs: cellsHash2 latticeResidue
// Position of a cell's point in the cell, in (0, 1): one of 761 positions.
vec2 cellsPlace2(vec2 cell, vec2 offset) {
    float h = cellsHash2(cell, offset);
    return (latticeResidue(h * vec4(209.0, 304.0, 1.0, 1.0) + vec4(97.0, 211.0, 0.0, 0.0)).xy + 0.5) * (1.0 / 761.0);
}
