// needs: cellsHash3
// Position of a cell's point in the cell, in (0, 1): 2048, 2048 and 1024 steps along x, y, z.
vec3 cellsPlace3(vec3 cell, vec3 offset) {
    uint h = cellsHash3(cell, offset);
    return (vec3(uvec3(h >> 21u, (h >> 10u) & 2047u, h & 1023u)) + 0.5) * vec3(1.0 / 2048.0, 1.0 / 2048.0, 1.0 / 1024.0);
}
