// needs: cellsCell2 cellsPlace2 cellsSearch2
// The cell point nearest to p + rest, bitwise equal across the cell. Error 6e-8 of the position,
// half an ULP.
vec2 cells2Centre(vec2 p, vec2 rest, float jitter, int metric) {
    vec2 cell, d;
    vec3 first, second;
    cellsCell2(p, rest, cell, d);
    cellsSearch2(cell, d, jitter, metric, 1, first, second);
    vec2 offset = floor(d + first.xy);
    vec2 place = 0.5 + jitter * (cellsPlace2(cell, offset) - 0.5);
    vec2 whole = floor(p);
    return whole + floor(p - whole + rest) + offset + place;
}
