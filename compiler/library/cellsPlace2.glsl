// needs: cellsHash2
// Where a square's point lies in it: 65536 places along each axis, in (0, 1).
vec2 cellsPlace2(vec2 cell, vec2 offset) {
    uint h = cellsHash2(cell, offset);
    return (vec2(uvec2(h >> 16u, h & 65535u)) + 0.5) * (1.0 / 65536.0);
}
