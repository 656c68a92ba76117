// needs: lattice latticeCell
// noise(p + rest).
float noiseLong(vec3 p, vec3 rest) {
    vec3 cell, d;
    latticeCell(p, rest, cell, d);
    return clamp(2.0 * lattice(cell, d), -1.0, 1.0);
}
