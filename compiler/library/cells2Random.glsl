// needs: cellsCell2 cellsHash2 cellsNumber cellsSearch2
// Random number in [0, 1] of the cell whose point is nearest to p + rest. Discontinuous at cell
// borders; exact elsewhere.
float cells2Random(vec2 p, vec2 rest, float jitter, int metric) {
    vec2 cell, d;
    vec3 first, second;
    cellsCell2(p, rest, cell, d);
    cellsSearch2(cell, d, jitter, metric, 1, first, second);
    return cellsNumber(cellsHash2(cell, floor(d + first.xy)));
}
