// needs: latticeAxis latticePermute
// Hashes in [0, 761) of a cell's eight corners, in latticeMix's order. One extra permutation of x
// makes (x, y) and (y, x) unrelated.
void latticeCorners(vec3 cell, out vec4 low, out vec4 high) {
    vec3 c = cell - 65536.0 * floor(cell * (1.0 / 65536.0));
    vec4 c0 = latticeAxis(c);
    vec4 c1 = latticeAxis((c + 1.0) * (1.0 - step(65535.5, c + 1.0)));
    vec4 line = latticePermute(vec4(c0.x, c1.x, c0.x, c1.x) + 17.0);
    vec4 square = latticePermute(line + vec4(c0.yy, c1.yy));
    low = latticePermute(square + c0.z);
    high = latticePermute(square + c1.z);
}
