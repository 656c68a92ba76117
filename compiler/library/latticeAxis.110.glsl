// needs: latticePermute latticeResidue
// Hash in [0, 761) of each of three whole coordinates in [0, 65536): all whole numbers below 2^24, hence exact.
// A coordinate of block b = c / 761, remainder r, enters as (b + 1) r + 3 b, so that blocks are no copies of each other.
vec4 latticeAxis(vec3 c) {
    vec3 block = floor((c + 0.5) * (1.0 / 761.0));
    vec3 rest = c - 761.0 * block;
    return latticePermute(latticeResidue(vec4(block * (rest + 3.0) + rest, 0.0)));
}
