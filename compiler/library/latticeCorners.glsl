// needs: latticeFinal
// Hashes of a cell's eight corners, in latticeMix's order: xor of products, then a finalizer. The
// wrap to [0, 65536) is exact for every finite cell.
void latticeCorners(vec3 cell, out uvec4 low, out uvec4 high) {
    const uvec3 factor = uvec3(0x9E3779B1u, 0x85EBCA77u, 0xC2B2AE3Du);
    uvec3 c = uvec3(ivec3(cell - 65536.0 * floor(cell * (1.0 / 65536.0))));
    uvec3 c0 = c * factor;
    uvec3 c1 = ((c + 1u) & 65535u) * factor;
    uvec4 square = uvec4(c0.x, c1.x, c0.x, c1.x) ^ uvec4(c0.yy, c1.yy);
    low = latticeFinal(square ^ (c0.z + 0x165667B1u));
    high = latticeFinal(square ^ (c1.z + 0x165667B1u));
}
