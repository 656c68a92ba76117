// needs: cellsHash3 latticeResidue
// Position of a cell's point in the cell, in (0, 1): one of 761 positions.
vec3 cellsPlace3(vec3 cell, vec3 offset) {
    float h = cellsHash3(cell, offset);
    return (latticeResidue(h * vec4(209.0, 304.0, 373.0, 1.0) + vec4(97.0, 211.0, 523.0, 0.0)).xyz + 0.5) * (1.0 / 761.0);
}
