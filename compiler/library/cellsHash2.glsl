// needs:
// 32-bit hash of cell + offset, with a period of 2^25 per axis; every bit is well mixed.
uint cellsHash2(vec2 cell, vec2 offset) {
    uvec2 c = (uvec2(ivec2(cell) + ivec2(offset)) & 33554431u) * uvec2(0x9E3779B1u, 0x85EBCA77u);
    uint h = c.x ^ c.y ^ 0x27D4EB2Fu;
    h = (h ^ (h >> 16u)) * 0x7FEB352Du;
    h = (h ^ (h >> 15u)) * 0x846CA68Bu;
    return h ^ (h >> 16u);
}
