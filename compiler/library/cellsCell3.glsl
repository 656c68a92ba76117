// needs:
// Splits p + rest into an integer cell, modulo 2^25, and a position d in [0, 1) in the cell. Exact.
void cellsCell3(vec3 p, vec3 rest, out vec3 cell, out vec3 d) {
    cell = floor(p);
    d = p - cell + rest;
    vec3 over = floor(d);
    d -= over;
    cell = cell - 33554432.0 * floor(cell * (1.0 / 33554432.0) + 0.5) + over;
}
