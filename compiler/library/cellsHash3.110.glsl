// needs: latticeAxis latticePermute
// Hash in [0, 761) of cell + offset, with a period of 65536 per axis. Exact in floats.
float cellsHash3(vec3 cell, vec3 offset) {
    vec3 c = cell - 65536.0 * floor(cell * (1.0 / 65536.0)) + offset;
    vec4 axis = latticeAxis(c - 65536.0 * floor(c * (1.0 / 65536.0)));
    return latticePermute(latticePermute(latticePermute(axis + 17.0) + axis.y) + axis.z).x;
}
