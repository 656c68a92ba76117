// needs: latticeAxis latticePermute
// Hash in [0, 761) of cell + offset, with a period of 65536 per axis. Exact in floats.
float cellsHash2(vec2 cell, vec2 offset) {
    vec2 c = cell - 65536.0 * floor(cell * (1.0 / 65536.0)) + offset;
    vec4 axis = latticeAxis(vec3(c - 65536.0 * floor(c * (1.0 / 65536.0)), 0.0));
    return latticePermute(latticePermute(axis + 17.0) + axis.y).x;
}
