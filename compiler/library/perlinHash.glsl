// needs:
// Low four bits of Jenkins' hash of `count` (2 or 3) integers, |cell| <= 2^24: lookup3's final mix,
// seeded with 0xDEADBEEF + 4 count + 13 as in OSL and MaterialX. For count 2, cell.z is 0. Exact.
uint perlinHashTurned(uint bits, int by) {
    return (bits << by) | (bits >> (32 - by));
}

float perlinHash(vec3 cell, int count) {
    uvec3 h = uvec3(ivec3(cell)) + (0xDEADBEEFu + 13u + 4u * uint(count));
    h.z = (h.z ^ h.y) - perlinHashTurned(h.y, 14);
    h.x = (h.x ^ h.z) - perlinHashTurned(h.z, 11);
    h.y = (h.y ^ h.x) - perlinHashTurned(h.x, 25);
    h.z = (h.z ^ h.y) - perlinHashTurned(h.y, 16);
    h.x = (h.x ^ h.z) - perlinHashTurned(h.z, 4);
    h.y = (h.y ^ h.x) - perlinHashTurned(h.x, 14);
    h.z = (h.z ^ h.y) - perlinHashTurned(h.y, 24);
    return float(h.z & 15u);
}
