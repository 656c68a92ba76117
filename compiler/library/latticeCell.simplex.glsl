// needs:
// Splits p + rest into an integer cell, modulo 196608, and a fraction in [0, 1).
void latticeCell(vec3 p, vec3 rest, out vec3 cell, out vec3 d) {
    cell = floor(p);
    d = p - cell + rest;
    vec3 over = floor(d);
    d -= over;
    cell = cell - 196608.0 * floor(cell * (1.0 / 196608.0)) + over;
}
