// needs:
// Hash of the square that lies `offset` from another, with a period of 2^25 along each axis: all 32 bits are good.
uint cellsHash2(vec2 cell, vec2 offset) {
    uvec2 c = (uvec2(ivec2(cell) + ivec2(offset)) & 33554431u) * uvec2(0x9E3779B1u, 0x85EBCA77u);
    uint h = c.x ^ c.y ^ 0x27D4EB2Fu;
    h = (h ^ (h >> 16u)) * 0x7FEB352Du;
    h = (h ^ (h >> 15u)) * 0x846CA68Bu;
    return h ^ (h >> 16u);
}
