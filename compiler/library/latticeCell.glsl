// needs:
// Splits p + rest into an integer cell, modulo 65536, and a fraction in [0, 1). Exact.
void latticeCell(vec3 p, vec3 rest, out vec3 cell, out vec3 d) {
    cell = floor(p);
    d = p - cell + rest;
    vec3 over = floor(d);
    d -= over;
    cell = cell - 65536.0 * floor(cell * (1.0 / 65536.0)) + over;
}
