// needs: latticePermutation
// GroIMP's hashes P[P[P[i] ^ j] ^ k] of a cell's eight corners, in latticeMix's order; 14 lookups.
// The wrap to [0, 65536) is exact for every finite cell.
void latticeCorners(vec3 cell, out ivec4 low, out ivec4 high) {
    ivec3 c0 = ivec3(cell - 65536.0 * floor(cell * (1.0 / 65536.0)));
    ivec3 c1 = (c0 + 1) & 65535;
    int x0 = latticePermutation(c0.x);
    int x1 = latticePermutation(c1.x);
    ivec4 square = ivec4(latticePermutation(x0 ^ c0.y), latticePermutation(x1 ^ c0.y),
                         latticePermutation(x0 ^ c1.y), latticePermutation(x1 ^ c1.y));
    low = ivec4(latticePermutation(square.x ^ c0.z), latticePermutation(square.y ^ c0.z),
                latticePermutation(square.z ^ c0.z), latticePermutation(square.w ^ c0.z));
    high = ivec4(latticePermutation(square.x ^ c1.z), latticePermutation(square.y ^ c1.z),
                 latticePermutation(square.z ^ c1.z), latticePermutation(square.w ^ c1.z));
}
