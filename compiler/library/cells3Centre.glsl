// needs: cellsCell3 cellsPlace3 cellsSearch3
// The cell point nearest to p + rest, bitwise equal across the cell. Error 6e-8 of the position,
// half an ULP.
vec3 cells3Centre(vec3 p, vec3 rest, float jitter, int metric) {
    vec3 cell, d;
    vec4 first, second;
    cellsCell3(p, rest, cell, d);
    cellsSearch3(cell, d, jitter, metric, 1, first, second);
    vec3 offset = floor(d + first.xyz);
    vec3 place = 0.5 + jitter * (cellsPlace3(cell, offset) - 0.5);
    vec3 whole = floor(p);
    return whole + floor(p - whole + rest) + offset + place;
}
