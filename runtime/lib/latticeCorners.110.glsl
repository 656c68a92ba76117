// needs: latticePermute latticeResidue
// Hashes in [0, 761) of the eight corners of a cell, lanes as latticeMix takes them: all whole numbers below 2^24, hence exact.
// A coordinate of block b = c / 761, remainder r, enters as (b + 1) r + 3 b, so that blocks are no copies of each other;
// x takes one permutation more than y, so that (x, y) and (y, x) are unrelated.
vec4 latticeAxis(vec3 c) {
    vec3 block = floor((c + 0.5) * (1.0 / 761.0));
    vec3 rest = c - 761.0 * block;
    return latticePermute(latticeResidue(vec4(block * (rest + 3.0) + rest, 0.0)));
}

void latticeCorners(vec3 cell, out vec4 low, out vec4 high) {
    vec3 c = cell - 65536.0 * floor(cell * (1.0 / 65536.0));
    vec4 c0 = latticeAxis(c);
    vec4 c1 = latticeAxis((c + 1.0) * (1.0 - step(65535.5, c + 1.0)));
    vec4 line = latticePermute(vec4(c0.x, c1.x, c0.x, c1.x) + 17.0);
    vec4 square = latticePermute(line + vec4(c0.yy, c1.yy));
    low = latticePermute(square + c0.z);
    high = latticePermute(square + c1.z);
}
