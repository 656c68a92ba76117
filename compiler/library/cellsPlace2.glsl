// needs: cellsHash2
// Position of a cell's point in the cell, in (0, 1): 65536 steps per axis.
vec2 cellsPlace2(vec2 cell, vec2 offset) {
    uint h = cellsHash2(cell, offset);
    return (vec2(uvec2(h >> 16u, h & 65535u)) + 0.5) * (1.0 / 65536.0);
}
