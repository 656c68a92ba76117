// needs:
// 32-bit hash of cell + offset, with a period of 2^25 per axis; every bit is well mixed.
uint cellsHash3(vec3 cell, vec3 offset) {
    uvec3 c = (uvec3(ivec3(cell) + ivec3(offset)) & 33554431u) * uvec3(0x9E3779B1u, 0x85EBCA77u, 0xC2B2AE3Du);
    uint h = c.x ^ c.y ^ (c.z + 0x165667B1u);
    h = (h ^ (h >> 16u)) * 0x7FEB352Du;
    h = (h ^ (h >> 15u)) * 0x846CA68Bu;
    return h ^ (h >> 16u);
}
