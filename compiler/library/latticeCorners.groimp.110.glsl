// needs: latticePermutation latticeXor
// GroIMP's hashes P[P[P[i] ^ j] ^ k] of a cell's eight corners, in latticeMix's order; 38 lookups.
// The wrap to [0, 65536) is exact for every finite cell.
float latticeStep(float hash, float c) {
    return latticePermutation(latticeXor(hash, c));
}

void latticeCorners(vec3 cell, out vec4 low, out vec4 high) {
    vec3 c0 = cell - 65536.0 * floor(cell * (1.0 / 65536.0));
    vec3 c1 = (c0 + 1.0) * (1.0 - step(65535.5, c0 + 1.0));
    float x0 = latticePermutation(c0.x);
    float x1 = latticePermutation(c1.x);
    vec4 square = vec4(latticeStep(x0, c0.y), latticeStep(x1, c0.y), latticeStep(x0, c1.y), latticeStep(x1, c1.y));
    low = vec4(latticeStep(square.x, c0.z), latticeStep(square.y, c0.z),
               latticeStep(square.z, c0.z), latticeStep(square.w, c0.z));
    high = vec4(latticeStep(square.x, c1.z), latticeStep(square.y, c1.z),
                latticeStep(square.z, c1.z), latticeStep(square.w, c1.z));
}
