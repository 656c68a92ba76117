// needs: latticePermute latticeResidue
// Hash in [0, 761) of each of three integer coordinates in [0, 65536): all integers stay below
// 2^24, hence exact. A coordinate 761 b + r contributes (b + 1) r + 3 b, so blocks of 761 differ.
vec4 latticeAxis(vec3 c) {
    vec3 block = floor((c + 0.5) * (1.0 / 761.0));
    vec3 rest = c - 761.0 * block;
    return latticePermute(latticeResidue(vec4(block * (rest + 3.0) + rest, 0.0)));
}
