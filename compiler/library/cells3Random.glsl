// needs: cellsCell3 cellsHash3 cellsNumber cellsSearch3
// Random number in [0, 1] of the cell whose point is nearest to p + rest. Discontinuous at cell
// borders; exact elsewhere.
float cells3Random(vec3 p, vec3 rest, float jitter, int metric) {
    vec3 cell, d;
    vec4 first, second;
    cellsCell3(p, rest, cell, d);
    cellsSearch3(cell, d, jitter, metric, 1, first, second);
    return cellsNumber(cellsHash3(cell, floor(d + first.xyz)));
}
